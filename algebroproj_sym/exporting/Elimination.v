(** Regular matrices over the reals, decided for rational entries by elimination.

    The entries are integers after each row is multiplied by a number.  The elimination looks at them modulo a prime
    number, so that they stay short: what is not zero modulo it is not zero.  Nothing needs to be believed of the
    number; with an unlucky one a regular matrix is not recognized. *)

From Coq Require Import Reals QArith Qreals List ZArith Lia Lra.
Import ListNotations.
Open Scope R_scope.
(** Matrices are lists of rows; a second factor is a list of columns. *)
Fixpoint dot (u v : list R) : R :=
  match u, v with a :: u, b :: v => a * b + dot u v | _, _ => 0 end.
Definition times (rows columns : list (list R)) : list (list R) := map (fun row => map (dot row) columns) rows.
Definition basis (n k : nat) : list R := map (fun j => if Nat.eqb j k then 1 else 0) (seq 0 n).
Definition unit_matrix (n : nat) : list (list R) :=
  map (fun i => map (fun j => if Nat.eqb i j then 1 else 0) (seq 0 n)) (seq 0 n).
(** A square matrix with an inverse: its determinant is not zero. *)
Definition regular_matrix (rows : list (list R)) : Prop :=
  exists columns, length columns = length rows /\ times rows columns = unit_matrix (length rows).
Fixpoint traverse {A B} (f : A -> option B) (l : list A) : option (list B) :=
  match l with
  | [] => Some []
  | a :: rest => match f a, traverse f rest with Some b, Some bs => Some (b :: bs) | _, _ => None end
  end.
Lemma nth_all {A} (d : A) l : map (fun k => List.nth k l d) (seq 0 (length l)) = l.
Proof.
  induction l as [|a l IH]; [reflexivity|].
  cbn [length seq map]. rewrite <- seq_shift, map_map. f_equal. exact IH.
Qed.
Fixpoint zipped {A B C} (f : A -> B -> C) (u : list A) (v : list B) : list C :=
  match u, v with a :: u, b :: v => f a b :: zipped f u v | _, _ => [] end.

(** * Elimination *)

Definition modulus : Z := 2147483647.

Fixpoint first_pivot (before rows : list (list Z)) : option (Z * list Z * list (list Z)) :=
  match rows with
  | (a :: r) :: rest => if (a mod modulus =? 0)%Z then first_pivot ((a :: r) :: before) rest else Some (a, r, before ++ rest)
  | _ => None
  end.
(** A row, times the pivot, minus a multiple of the row of the pivot. *)
Definition reduced (a : Z) (r row : list Z) : list Z :=
  match row with [] => [] | c :: d => zipped (fun x y => (a * x - c * y) mod modulus)%Z d r end.
Fixpoint eliminated (n : nat) (rows : list (list Z)) : bool :=
  match n, rows with
  | O, [] => true
  | S n, _ => match first_pivot [] rows with Some (a, r, others) => eliminated n (map (reduced a r) others) | None => false end
  | _, _ => false
  end.

Definition congruent (z : Z) (x : R) : Prop := exists k, x = IZR (z + k * modulus).
(** An equation in n unknowns: coefficients, and the right side. *)
Definition read_as (n : nat) (row : list Z) (s : list R * R) : Prop := Forall2 congruent row (fst s) /\ length row = n.
Definition solves (x : list R) (s : list R * R) : Prop := dot (fst s) x = snd s.

Lemma same_length {A B} (P : A -> B -> Prop) u v : Forall2 P u v -> length u = length v.
Proof. induction 1; simpl; congruence. Qed.

Lemma pivot_sound (P : list Z -> list R * R -> Prop) rows system : Forall2 P rows system ->
  forall before known a r others, Forall2 P before known -> first_pivot before rows = Some (a, r, others) ->
  (a mod modulus <> 0)%Z /\ exists s rest, P (a :: r) s /\ Forall2 P others rest /\
    forall Q : list R * R -> Prop, Q s -> Forall Q rest -> Forall Q known /\ Forall Q system.
Proof.
  induction 1 as [|row s rows system Hs H IH]; cbn [first_pivot]; intros before known a r others B E; [discriminate|].
  destruct row as [|b row]; [discriminate|]. destruct (Z.eqb_spec (b mod modulus) 0) as [|N].
  - destruct (IH _ (s :: known) a r others (Forall2_cons _ _ Hs B) E) as (Ha & t & rest & Ht & Hr & back).
    split; [assumption|]. exists t, rest. repeat split; trivial; destruct (back Q) as [K L]; trivial; inversion_clear K; auto.
  - injection E as <- <- <-. split; [assumption|]. exists s, (known ++ system)%list. split; [assumption|].
    split; [now apply Forall2_app|]. intros Q Qs Qr. apply Forall_app in Qr as [K L]. auto.
Qed.

Lemma congruent_nonzero z x : congruent z x -> (z mod modulus <> 0)%Z -> x <> 0.
Proof. intros [k ->] N E. apply eq_IZR in E. apply N. replace z with ((- k) * modulus)%Z by lia. apply Z_mod_mult. Qed.

Lemma congruent_reduced a c x y (a' c' x' y' : R) : congruent a a' -> congruent c c' -> congruent x x' -> congruent y y' ->
  congruent ((a * x - c * y) mod modulus) (a' * x' - c' * y').
Proof.
  intros [i ->] [j ->] [k ->] [l ->]. rewrite <- !mult_IZR, <- minus_IZR.
  exists ((a * x - c * y) / modulus + a * k + i * x + i * k * modulus - c * l - j * y - j * l * modulus)%Z.
  f_equal. rewrite Z.mod_eq by discriminate. ring.
Qed.

Lemma reduced_rows a c (a' c' : R) : congruent a a' -> congruent c c' -> forall d d' r r',
  Forall2 congruent d d' -> Forall2 congruent r r' ->
  Forall2 congruent (zipped (fun x y => (a * x - c * y) mod modulus)%Z d r) (zipped (fun x y => a' * x - c' * y) d' r').
Proof.
  intros Ha Hc d d' r r' D. revert r r'. induction D as [|x x' d d' Hx D IH]; intros r r' [|y y' s s' Hy S]; constructor.
  - now apply congruent_reduced.
  - now apply IH.
Qed.

Lemma dot_zipped a c d : forall r w, length d = length r ->
  dot (zipped (fun x y => a * x - c * y) d r) w = a * dot d w - c * dot r w.
Proof.
  induction d as [|x d IH]; intros [|y r] [|v w] L; try discriminate; simpl; try ring.
  rewrite IH by now injection L. ring.
Qed.

Lemma zipped_length {A B C} (f : A -> B -> C) u : forall v, length u = length v -> length (zipped f u v) = length u.
Proof. induction u as [|a u IH]; intros [|b v] L; try discriminate; simpl; auto. Qed.

Lemma eliminated_sound n : forall rows system, Forall2 (read_as n) rows system -> eliminated n rows = true ->
  exists x, Forall (solves x) system.
Proof.
  induction n as [|n IH]; intros rows system H E; cbn [eliminated] in E.
  { destruct H; [|discriminate]. exists []. constructor. }
  destruct (first_pivot [] rows) as [[[a r] others]|] eqn:P; [|discriminate].
  apply (pivot_sound _ _ _ H [] []) in P as (N & s & rest & [Hs Ls] & F & back); [|constructor].
  destruct s as [[|a' r'] y]; cbn [fst] in Hs; inversion Hs as [|? ? ? ? Ha Hr]; subst; clear Hs.
  pose proof (congruent_nonzero a a' Ha N) as N'.
  pose (image := fun t : list R * R =>
    match fst t with [] => t | c :: d => (zipped (fun x y => a' * x - c * y) d r', a' * snd t - c * y) end).
  destruct (IH (map (reduced a r) others) (map image rest)) as [w Hw]; [|exact E|].
  { clear back E. induction F as [|row t others rest [Ht Lt] F IHF]; constructor; [|exact IHF].
    unfold image. destruct Ht as [|c c' d d' Hc Hd]; [discriminate|]. split; cbn [fst reduced].
    - now apply reduced_rows.
    - injection Lt as Lt. injection Ls as Ls. rewrite zipped_length; congruence. }
  exists ((y - dot r' w) / a' :: w). apply back.
  { unfold solves; cbn [fst snd dot]. field. assumption. }
  apply Forall_map in Hw. clear back E. induction F as [|row t others rest [Ht Lt] F IHF]; constructor;
    inversion_clear Hw as [|? ? W W']; [|now apply IHF].
  unfold image in W. destruct t as [u z]; cbn [fst snd] in *. destruct Ht as [|c c' d d' Hc Hd]; [discriminate|].
  unfold solves in *; cbn [fst snd dot] in *.
  assert (length d' = length r') as L by (apply same_length in Hd, Hr; injection Lt as Lt; injection Ls as Ls; lia).
  rewrite dot_zipped in W by assumption. apply Rmult_eq_reg_l with a'; [|assumption].
  transitivity (c' * (y - dot r' w) + a' * dot d' w); [field; assumption|lra].
Qed.

Lemma regular_by rows : (forall y, length y = length rows -> exists x, Forall (solves x) (combine rows y)) ->
  regular_matrix rows.
Proof.
  intro H. unfold regular_matrix. set (n := length rows) in *.
  assert (forall js, exists columns, Forall2 (fun x j => map (fun row => dot row x) rows = basis n j) columns js) as C.
  { induction js as [|j js [columns C]]; [now exists []|].
    destruct (H (basis n j)) as [x X]; [unfold basis; now rewrite map_length, seq_length|].
    exists (x :: columns). constructor; [|assumption]. clear - X. subst n.
    assert (length rows = length (basis (length rows) j)) as L by (unfold basis; now rewrite map_length, seq_length).
    revert L X. generalize (basis (length rows) j). clear. induction rows as [|row rows IH]; intros [|b y] L X;
      try discriminate; [reflexivity|]. inversion_clear X as [|? ? X1 X2]. cbn [map]. f_equal; [exact X1|].
    apply IH; [now injection L|assumption]. }
  destruct (C (seq 0 n)) as [columns F]. exists columns. split; [rewrite (same_length _ _ _ F); apply seq_length|].
  unfold times, unit_matrix. rewrite <- (nth_all [] rows) at 1. fold n. rewrite map_map. apply map_ext_in.
  intros i I. apply in_seq in I as [_ I]. cbn in I. induction F as [|x j columns js E F IH]; [reflexivity|]. cbn [map]. f_equal; [|exact IH].
  transitivity (List.nth i (map (fun row => dot row x) rows) 0).
  { symmetry. rewrite (nth_indep _ 0 (dot [] x)) by now rewrite map_length.
    exact (map_nth (fun row => dot row x) rows [] i). }
  rewrite E. unfold basis.
  rewrite (nth_indep _ 0 (if Nat.eqb 0 j then 1 else 0)) by now rewrite map_length, seq_length.
  now rewrite (map_nth (fun k => if Nat.eqb k j then 1 else 0)), seq_nth.
Qed.

(** * Rational entries *)

(** A row of rational numbers, times their common denominator. *)
Definition integral (d : Z) (q : Q) : option Z :=
  let z := (d * Qnum q / Zpos (Qden q))%Z in if (z * Zpos (Qden q) =? d * Qnum q)%Z then Some z else None.
Definition integers (row : list Q) : option (list Z) :=
  let d := fold_right (fun q d => Z.lcm (Zpos (Qden q)) d) 1%Z row in
  if (d =? 0)%Z then None else traverse (integral d) row.
Definition invertible (m : list (list Q)) : bool :=
  match traverse integers (map (map Qred) m) with
  | Some rows => forallb (fun row => Nat.eqb (length row) (length m)) rows && eliminated (length m) rows
  | None => false
  end.

Lemma integral_real d q z : integral d q = Some z -> IZR d * Q2R q = IZR z.
Proof.
  unfold integral. destruct (Z.eqb_spec (d * Qnum q / Zpos (Qden q) * Zpos (Qden q)) (d * Qnum q)) as [E|]; [|discriminate].
  intro H; injection H as H. rewrite H in E. apply (f_equal IZR) in E. rewrite !mult_IZR in E. unfold Q2R.
  apply Rmult_eq_reg_r with (IZR (Zpos (Qden q))); [|apply not_0_IZR; discriminate].
  rewrite E. field. apply not_0_IZR; discriminate.
Qed.
Lemma Q2R_red q : Q2R (Qred q) = Q2R q.
Proof. apply Qeq_eqR, Qred_correct. Qed.

Lemma integers_real row zs : integers (map Qred row) = Some zs ->
  exists d, d <> 0 /\ Forall2 congruent zs (map (fun q => d * Q2R q) row).
Proof.
  unfold integers. set (d := fold_right _ _ _). destruct (Z.eqb_spec d 0) as [|N]; [discriminate|].
  intro T. exists (IZR d). split; [now apply not_0_IZR|]. clearbody d. revert zs T.
  induction row as [|q row IH]; cbn [map traverse]; intros zs T; [injection T as <-; constructor|].
  destruct (integral d (Qred q)) as [z|] eqn:E; [|discriminate]. destruct (traverse _ _); [|discriminate].
  injection T as <-. constructor; [|now apply IH]. exists 0%Z.
  apply integral_real in E. rewrite Q2R_red in E. rewrite E. f_equal. ring.
Qed.

Lemma dot_scaled d (x : list R) row : dot (map (fun q => d * Q2R q) row) x = d * dot (map Q2R row) x.
Proof.
  revert x; induction row as [|q row IH]; intros [|b x]; simpl; try ring. rewrite IH. ring.
Qed.

Lemma invertible_regular m : invertible m = true -> regular_matrix (map (map Q2R) m).
Proof.
  unfold invertible. destruct (traverse integers (map (map Qred) m)) as [rows|] eqn:T; [|discriminate].
  intro H. apply andb_prop in H as [L E]. apply regular_by. intros y Ly. rewrite map_length in Ly.
  assert (exists system, Forall2 (read_as (length m)) rows system /\
    forall x, Forall (solves x) system -> Forall (solves x) (combine (map (map Q2R) m) y)) as (system & F & back).
  { clear E. revert L. generalize (length m) as n. clear Ly. revert rows y T. induction m as [|row m IH];
      cbn [map traverse]; intros rows y T n L.
    { injection T as <-. exists []. split; [constructor|auto]. }
    destruct (integers (map Qred row)) as [zs|] eqn:I; [|discriminate].
    destruct (traverse integers _) as [others|]; [|discriminate]. injection T as <-.
    cbn [forallb] in L. apply andb_prop in L as [L1 L]. apply Nat.eqb_eq in L1.
    destruct (integers_real row zs I) as (d & D & C).
    destruct y as [|b y].
    { destruct (IH others [] eq_refl n L) as (system & F & back).
      exists ((map (fun q => d * Q2R q) row, 0) :: system). split; [constructor; [now split|assumption]|].
      intros x _. destruct (map _ m); constructor. }
    destruct (IH others y eq_refl n L) as (system & F & back).
    exists ((map (fun q => d * Q2R q) row, d * b) :: system). split; [constructor; [now split|assumption]|].
    intros x X. inversion_clear X as [|? ? X1 X2]. apply Forall_cons; [|exact (back x X2)].
    unfold solves in *; cbn [fst snd] in *. rewrite dot_scaled in X1. now apply Rmult_eq_reg_l with d. }
  destruct (eliminated_sound _ _ _ F E) as [x X]. exists x. now apply back.
Qed.
