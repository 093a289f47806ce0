; The errors of b, a and c move b^2 - c a by at most the terms of the image filter's E, without its
; roundings (reference/visibility/visibility_kernel.h). bh is b^ there.
(declare-const b Real) (declare-const bh Real) (declare-const B Real) (declare-const Eb Real)
(declare-const a Real) (declare-const ah Real) (declare-const A Real) (declare-const Ea Real)
(declare-const c Real) (declare-const ch Real) (declare-const rc Real)
(define-fun size ((x Real)) Real (ite (< x 0) (- x) x))
(assert (and (<= (size b) B) (<= (size bh) (* 1.01 B)) (<= (size (- bh b)) Eb)))
(assert (and (<= 0 a A) (<= (size (- ah a)) Ea) (<= (size (- ch c)) rc)))
; b^2 and c a separately: together they are at most the sum.
(assert (or (> (size (- (* bh bh) (* b b))) (* 2.2 B Eb))
            (> (size (- (* ch ah) (* c a))) (+ (* 1.1 (size ch) Ea) (* 1.1 rc A)))))
(check-sat)
