(** Linear algebra over the reals, as the derivations do it: the objects of the exported files are made of this.

    Matrices are lists of rows, vectors are matrices of one column.  Every operation computes on lists, so that a
    theorem about an object is one about the formulas of its entries. *)

From Coq Require Import Reals List Lra.
From Algebroproj Require Import Formulas.
Import ListNotations.
Open Scope R_scope.

Definition matrix : Type := list (list R).

Definition entry (m : matrix) (i j : nat) : R := List.nth j (List.nth i m []) 0.
Definition part (m : matrix) (rows columns : list nat) : matrix := map (fun i => map (entry m i) columns) rows.
Definition sum (a b : matrix) : matrix := zipped (zipped Rplus) a b.
Definition difference (a b : matrix) : matrix := zipped (zipped Rminus) a b.
Definition negated (a : matrix) : matrix := map (map Ropp) a.
Definition scaled (k : R) (a : matrix) : matrix := map (map (Rmult k)) a.
Definition divided (a : matrix) (k : R) : matrix := map (map (fun x => x / k)) a.
Definition beside (a b : matrix) : matrix := zipped (@app R) a b.
Definition stacked (a b : matrix) : matrix := a ++ b.
Fixpoint transposed (m : matrix) : matrix :=
  match m with
  | [] => []
  | [row] => map (fun x => [x]) row
  | row :: rest => zipped cons row (transposed rest)
  end.
Definition product (a b : matrix) : matrix := times a (transposed b).
Definition scalar_product (a b : matrix) : R := dot (concat a) (concat b).
Definition cross_product (a b : matrix) : matrix :=
  match concat a, concat b with
  | [a0; a1; a2], [b0; b1; b2] => [[a1 * b2 - a2 * b1]; [a2 * b0 - a0 * b2]; [a0 * b1 - a1 * b0]]
  | _, _ => []
  end.

Fixpoint without {A} (k : nat) (l : list A) : list A :=
  match l, k with [], _ => [] | _ :: l, O => l | a :: l, S k => a :: without k l end.
(** By the first row: its entries with alternating signs times the determinants of what is left. *)
Fixpoint alternating (sign : bool) (row cofactors : list R) : R :=
  match row, cofactors with
  | a :: row, c :: cofactors =>
      (if sign then - (a * c) else a * c) + alternating (negb sign) row cofactors
  | _, _ => 0
  end.
Fixpoint determinant_of (n : nat) (m : matrix) : R :=
  match n, m with
  | S n, row :: rest =>
      alternating false row (map (fun k => determinant_of n (map (without k) rest)) (seq 0 (length row)))
  | _, _ => 1
  end.
Definition determinant (m : matrix) : R := determinant_of (length m) m.
Definition cofactor (m : matrix) (i j : nat) : R :=
  let minor := determinant (map (without j) (without i m)) in if Nat.even (i + j) then minor else - minor.
Definition adjugate (m : matrix) : matrix :=
  map (fun j => map (fun i => cofactor m i j) (seq 0 (length m))) (seq 0 (length m)).
Definition inverse (m : matrix) : matrix := divided (adjugate m) (determinant m).
Fixpoint replaced {A} (k : nat) (a : A) (l : list A) : list A :=
  match l, k with [], _ => [] | _ :: l, O => a :: l | b :: l, S k => b :: replaced k a l end.
(** Cramer's rule. *)
Definition solution (m b : matrix) : matrix :=
  map (fun j => [determinant (zipped (fun row x => replaced j x row) m (concat b)) / determinant m])
    (seq 0 (length m)).
(** Equations that are linear in unknowns: what they are where all are zero, and where one of them is 1. *)
Definition system_matrix (at_zero : matrix) (at_units : list matrix) : matrix :=
  transposed (map (fun m => concat (difference m at_zero)) at_units).

(** The rows of a table where conditions are not 0. *)
Fixpoint chosen_rows (conditions : list R) (m : matrix) : matrix :=
  match conditions, m with
  | c :: conditions, row :: m => if Req_EM_T c 0 then chosen_rows conditions m else row :: chosen_rows conditions m
  | _, _ => []
  end.
Definition chosen (conditions m : matrix) : matrix := chosen_rows (concat conditions) m.
Lemma chosen_row conditions row m : chosen_rows (1 :: conditions) (row :: m) = row :: chosen_rows conditions m.
Proof. simpl. destruct (Req_EM_T 1 0); [lra|reflexivity]. Qed.
Lemma left_row conditions row m : chosen_rows (0 :: conditions) (row :: m) = chosen_rows conditions m.
Proof. simpl. destruct (Req_EM_T 0 0); [reflexivity|lra]. Qed.
Ltac choose :=
  repeat match goal with side := _ |- _ => subst side end;
  unfold chosen; cbn [concat app]; repeat rewrite ?chosen_row, ?left_row; reflexivity.

(** Lemmas are looked for in the left side alone. *)
Ltac name_right_side := lazymatch goal with |- _ = ?r => let right := fresh "right" in set (right := r) end.

(** * Theorems about matrices from equations between entries *)

Definition left_side (env : list R) (g : goal) : R := let '(Equation a _ _ _ _) := g in eval env a.
Definition right_side (env : list R) (g : goal) : R := let '(Equation _ b _ _ _) := g in eval env b.

Lemma nonzero_by d : 1 / d * d = 1 -> d <> 0.
Proof. intros E ->. lra. Qed.

Definition equal (g : goal) : literal := let '(Equation a b _ _ _) := g in Equal a b.

Theorem same_matrix env (rows : list (list goal)) :
  all (map (concludes env) (concat rows)) -> map (map (left_side env)) rows = map (map (right_side env)) rows.
Proof.
  rewrite all_map. induction rows as [|row rows IH]; cbn [concat map]; intro H; [reflexivity|].
  apply Forall_app in H as [H1 H2]. f_equal; [|now apply IH]. clear IH H2.
  induction H1 as [|[a b p m c] row E _ IH]; [reflexivity|]. cbn [map]. f_equal; [exact E|exact IH].
Qed.
