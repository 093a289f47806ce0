; U without normalising twice: (up x W)/|up x W| = u/|u|, where u = up x w, w = E - A, W = w/|w|,
; since |w| cancels. docs/problem.md, Camera, has the left side; reference/internal/formulas.h
; computes the right side. Here p is up, u and w are the lengths of these vectors, and n is the
; length of up x W = (nx, ny, nz).
(set-logic QF_NRA)
(define-fun dot ((ax Real) (ay Real) (az Real) (bx Real) (by Real) (bz Real)) Real
  (+ (* ax bx) (* ay by) (* az bz)))
(declare-const wx Real) (declare-const wy Real) (declare-const wz Real)
(declare-const px Real) (declare-const py Real) (declare-const pz Real)
(declare-const w Real)
(assert (and (> w 0) (= (* w w) (dot wx wy wz wx wy wz))))
(define-fun ux () Real (- (* py wz) (* pz wy)))
(define-fun uy () Real (- (* pz wx) (* px wz)))
(define-fun uz () Real (- (* px wy) (* py wx)))
(declare-const u Real)
(assert (and (> u 0) (= (* u u) (dot ux uy uz ux uy uz))))
(declare-const Wx Real) (declare-const Wy Real) (declare-const Wz Real)
(assert (and (= wx (* w Wx)) (= wy (* w Wy)) (= wz (* w Wz))))
(define-fun nx () Real (- (* py Wz) (* pz Wy)))
(define-fun ny () Real (- (* pz Wx) (* px Wz)))
(define-fun nz () Real (- (* px Wy) (* py Wx)))
(declare-const n Real)
(assert (and (> n 0) (= (* n n) (dot nx ny nz nx ny nz))))
(assert (not (and (= (* nx u) (* ux n)) (= (* ny u) (* uy n)) (= (* nz u) (* uz n)))))
(check-sat)
