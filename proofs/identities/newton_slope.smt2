; F(s) = |L + s d - C|^2 - r^2 is equal to a s^2 - 2 b s + c. At a root its slope 2 (a s - b) is 2
; sqrt(disc) or -2 sqrt(disc), since its square is 4 (b^2 - a c). fast/methods/intersect_robust.cpp
; divides by this slope, not by the slope at s0.
(set-logic QF_NRA)
(define-fun dot ((ax Real) (ay Real) (az Real) (bx Real) (by Real) (bz Real)) Real
  (+ (* ax bx) (* ay by) (* az bz)))
(declare-const Tx Real) (declare-const Ty Real) (declare-const Tz Real)
(declare-const dx Real) (declare-const dy Real) (declare-const dz Real)
(declare-const r Real) (declare-const s Real)
(define-fun a () Real (dot dx dy dz dx dy dz))
(define-fun b () Real (dot Tx Ty Tz dx dy dz))
(define-fun c () Real (- (dot Tx Ty Tz Tx Ty Tz) (* r r)))
(define-fun x () Real (- (* s dx) Tx))
(define-fun y () Real (- (* s dy) Ty))
(define-fun z () Real (- (* s dz) Tz))
(define-fun F () Real (- (dot x y z x y z) (* r r)))
(define-fun slope () Real (* 2 (- (* a s) b)))
(assert (not (and (= F (+ (- (* a s s) (* 2 b s)) c))
                  (=> (= F 0) (= (* slope slope) (* 4 (- (* b b) (* a c))))))))
(check-sat)
