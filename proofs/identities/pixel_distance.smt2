; l = |P - E| = sqrt(n^2 + alpha^2 + beta^2), which does not depend on the axes. For all U, V, W and
; g = n W + alpha U + beta V, the difference of |g|^2 and n^2 + alpha^2 + beta^2 consists of terms
; with |U|^2 - 1, U.V and so on, which are all 0 for perpendicular unit vectors (third_axis.smt2).
; docs/problem.md, Camera; fast/methods/pixel_ray_focal.cpp.
(set-logic QF_NRA)
(define-fun dot ((ax Real) (ay Real) (az Real) (bx Real) (by Real) (bz Real)) Real
  (+ (* ax bx) (* ay by) (* az bz)))
(declare-const Ux Real) (declare-const Uy Real) (declare-const Uz Real)
(declare-const Vx Real) (declare-const Vy Real) (declare-const Vz Real)
(declare-const Wx Real) (declare-const Wy Real) (declare-const Wz Real)
(declare-const n Real) (declare-const alpha Real) (declare-const beta Real)
(define-fun gx () Real (+ (* n Wx) (* alpha Ux) (* beta Vx)))
(define-fun gy () Real (+ (* n Wy) (* alpha Uy) (* beta Vy)))
(define-fun gz () Real (+ (* n Wz) (* alpha Uz) (* beta Vz)))
(assert (not (= (- (dot gx gy gz gx gy gz) (+ (* n n) (* alpha alpha) (* beta beta)))
  (+ (* n n (- (dot Wx Wy Wz Wx Wy Wz) 1))
     (* alpha alpha (- (dot Ux Uy Uz Ux Uy Uz) 1))
     (* beta beta (- (dot Vx Vy Vz Vx Vy Vz) 1))
     (* 2 n alpha (dot Wx Wy Wz Ux Uy Uz))
     (* 2 alpha beta (dot Ux Uy Uz Vx Vy Vz))
     (* 2 beta n (dot Vx Vy Vz Wx Wy Wz))))))
(check-sat)
