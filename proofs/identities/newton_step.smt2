; Newton's step from s0 with the slope F'(s) of F = a s^2 - 2 b s + c at its root s: s1 = s0 -
; F(s0)/F'(s) leaves the error s1 - s = -(s0 - s)^2 a/F'(s), exactly. With s0 = s (1 + e) and F'(s) =
; 2 sqrt(disc) or -2 sqrt(disc) (newton_slope.smt2), its size is s e^2 g with g = a s/(2 sqrt(disc)).
; Used by fast/methods/intersect_robust.cpp.
(set-logic QF_NRA)
(declare-const a Real) (declare-const b Real) (declare-const c Real)
(declare-const s Real) (declare-const s0 Real) (declare-const s1 Real)
(define-fun F ((t Real)) Real (+ (- (* a t t) (* 2 b t)) c))
(define-fun slope () Real (* 2 (- (* a s) b)))
(assert (and (= (F s) 0) (not (= slope 0))))
(assert (= (* (- s0 s1) slope) (F s0)))
(assert (not (= (* (- s1 s) slope) (- (* a (- s0 s) (- s0 s))))))
(check-sat)
