; Lagrange's identity: b^2 - a c = a r^2 - |T x d|^2, where a = |d|^2, b = T.d, c = |T|^2 - r^2.
; Used by fast/internal/robust_guess.h, fast/internal/intersect_formulas.h,
; fast/methods/intersect_cross.cpp and reference/internal/formulas.h for the discriminant.
(set-logic QF_NRA)
(define-fun dot ((ax Real) (ay Real) (az Real) (bx Real) (by Real) (bz Real)) Real
  (+ (* ax bx) (* ay by) (* az bz)))
(declare-const Tx Real) (declare-const Ty Real) (declare-const Tz Real)
(declare-const dx Real) (declare-const dy Real) (declare-const dz Real)
(declare-const r Real)
(define-fun a () Real (dot dx dy dz dx dy dz))
(define-fun b () Real (dot Tx Ty Tz dx dy dz))
(define-fun c () Real (- (dot Tx Ty Tz Tx Ty Tz) (* r r)))
(define-fun mx () Real (- (* Ty dz) (* Tz dy)))
(define-fun my () Real (- (* Tz dx) (* Tx dz)))
(define-fun mz () Real (- (* Tx dy) (* Ty dx)))
(assert (not (= (- (* b b) (* a c)) (- (* a r r) (dot mx my mz mx my mz)))))
(check-sat)
