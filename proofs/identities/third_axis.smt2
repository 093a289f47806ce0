; V = W x U is a unit vector, perpendicular to W and U, if these are perpendicular unit vectors.
; docs/problem.md, Camera.
(set-logic QF_NRA)
(define-fun dot ((ax Real) (ay Real) (az Real) (bx Real) (by Real) (bz Real)) Real
  (+ (* ax bx) (* ay by) (* az bz)))
(declare-const Ux Real) (declare-const Uy Real) (declare-const Uz Real)
(declare-const Wx Real) (declare-const Wy Real) (declare-const Wz Real)
(assert (= (dot Ux Uy Uz Ux Uy Uz) 1))
(assert (= (dot Wx Wy Wz Wx Wy Wz) 1))
(assert (= (dot Ux Uy Uz Wx Wy Wz) 0))
(define-fun Vx () Real (- (* Wy Uz) (* Wz Uy)))
(define-fun Vy () Real (- (* Wz Ux) (* Wx Uz)))
(define-fun Vz () Real (- (* Wx Uy) (* Wy Ux)))
(assert (not (and (= (dot Vx Vy Vz Vx Vy Vz) 1) (= (dot Vx Vy Vz Ux Uy Uz) 0)
                  (= (dot Vx Vy Vz Wx Wy Wz) 0))))
(check-sat)
