from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

class Roots:
    def __init__(self, root: str = ..., t_min: float = ..., t_max: float = ..., ends: str = ...,
                 t_unit: str = ..., culling: str = ...) -> None: ...

class Camera:
    def __init__(self, eye: Sequence[float], look_at: Sequence[float], up: Sequence[float],
                 near: float, left: float, right: float, bottom: float, top: float, width: int,
                 height: int, *, rows: str = ..., samples: str = ...,
                 origin: str = ...) -> None: ...

class Answers:
    arrays: dict[str, NDArray[Any]]
    def __getattr__(self, name: str) -> NDArray[Any]: ...

class Verdict:
    law: str
    finding: str
    cases: int
    comparisons: int
    excused: int
    reason: str
    text: str
    passes: bool
    sentences: list[str]
    replay: str
    shrunk: dict[str, NDArray[np.float64]] | None

def decide(origins: ArrayLike | Camera, directions: ArrayLike | None, centres: ArrayLike,
           radii: ArrayLike, *, roots: Roots | None = ..., threads: int = ..., invalid: str = ...,
           points: bool = ...) -> Answers: ...
def enclose(origins: ArrayLike | Camera, directions: ArrayLike | None, centres: ArrayLike,
            radii: ArrayLike, *, roots: Roots | None = ..., threads: int = ...,
            invalid: str = ...) -> Answers: ...
def round(origins: ArrayLike | Camera, directions: ArrayLike | None, centres: ArrayLike,
          radii: ArrayLike, *, roots: Roots | None = ..., threads: int = ...,
          invalid: str = ...) -> Answers: ...
def condition(origins: ArrayLike | Camera, directions: ArrayLike | None, centres: ArrayLike,
              radii: ArrayLike, *, roots: Roots | None = ..., threads: int = ...,
              invalid: str = ...) -> Answers: ...
def errors(origins: ArrayLike | Camera, directions: ArrayLike | None, centres: ArrayLike,
           radii: ArrayLike, *, roots: Roots | None = ..., threads: int = ..., invalid: str = ...,
           is_hit: ArrayLike, s: ArrayLike | None = ..., points: ArrayLike | None = ...
           ) -> Answers: ...
def nearest(origins: ArrayLike | Camera, directions: ArrayLike | None, centres: ArrayLike,
            radii: ArrayLike, *, roots: Roots | None = ..., threads: int = ...,
            invalid: str = ...) -> Answers: ...
def image(camera: Camera, centres: ArrayLike, radii: ArrayLike, **options: Any) -> Answers: ...
def judge(function: Callable[..., Any], law: str = ..., source: str = ..., *, cases: int = ...,
          seed: int = ..., **promises: Any) -> Verdict: ...
