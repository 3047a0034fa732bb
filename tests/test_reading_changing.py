r"""Documents in which a letter, a range or a thing changes on the way, and others that only look so."""

import pytest

from algebroproj_sym.reading import document_of, read_document

pytestmark = pytest.mark.usefixtures("verdicts_alone")

CHANGING = {
    "anew: abstract heading and text behind": (
        r"\section{Diffusion} Let the diffusivity be \[ D = \frac{l^2}{t}. \] \section{Optics} \[ f = "
        r"\frac{D}{2} \] with lens diameter $D$. Thus \[ f = \frac{l^2}{2 t}. \]",
        True,
    ),
    "anew: paragraph heading": (
        r"\paragraph{Beam.} Its inertia is \[ I = b h^3. \] \paragraph{Circuit.} The current $I$ gives "
        r"\[ U = R I. \] So \[ U = R b h^3. \]",
        True,
    ),
    "anew: bold run-in heading": (
        "**Beam.** Its inertia is\n\n$$ I = b h^3 $$\n\n**Circuit.** The current $I$ gives\n\n$$ U = R "
        "I $$\n\nSo\n\n$$ U = R b h^3 $$\n",
        False,
    ),
    "anew: description list": (
        r"\section{Gas} The pressure law is \[ p = n T. \] \section{Motion} "
        r"\begin{description}\item[$p$] momentum\item[$m$] mass\end{description} \[ v = \frac{p}{m} \] "
        r"Hence \[ v = \frac{n T}{m}. \]",
        True,
    ),
    "anew: table of symbols in LaTeX": (
        r"\section{Gas} The pressure law is \[ p = n T. \] \section{Motion} \begin{tabular}{ll} $p$ & "
        r"momentum \\ $m$ & mass \end{tabular} \[ v = \frac{p}{m} \] Hence \[ v = \frac{n T}{m}. \]",
        True,
    ),
    "anew: symbol in brackets behind the name": (
        "# Heat\n\nThe flow of heat is\n\n$$ q = k g $$\n\n# Charge\n\nThe electric charge ($q$) sets "
        "the force\n\n$$ F = q E $$\n\nso that\n\n$$ F = k g E $$\n",
        False,
    ),
    "anew: called": (
        r"\section{A} Its slope is \[ m = \frac{y}{x}. \] \section{B} The mass is called $m$. \[ F = m a "
        r"\] Thus \[ F = \frac{a y}{x}. \]",
        True,
    ),
    "anew: dash": (
        "## Slope\n\n$$ m = y / x $$\n\n## Force\n\nSymbols:\n\n- $m$ – mass\n- $a$ – acceleration\n\n"
        "$$ F = m a $$\n\nThus\n\n$$ F = a y / x $$\n",
        False,
    ),
    "anew: number in text": (
        r"\section{A} The gain is \[ \mu = 3 a. \] \section{B} For steel on ice $\mu = 0.03$. \[ F = \mu "
        r"N \] Hence \[ F = 3 a N. \]",
        True,
    ),
    "anew: let be given": (
        r"\section{A} The height is \[ h = a + b. \] \section{B} Let $h$ be Planck's constant. \[ E = h "
        r"f \] Hence \[ E = (a + b) f. \]",
        True,
    ),
    "anew: in Part": (
        r"\part{Statics} The area moment is \[ J = a^4. \] \part{Fields} The current density is $J$. \[ "
        r"I = J A \] Hence \[ I = a^4 A. \]",
        True,
    ),
    "anew: star heading": (
        r"\section*{Statics} The area moment is \[ J = a^4. \] \section*{Fields} A current density $J$ "
        r"flows. \[ I = J A \] Hence \[ I = a^4 A. \]",
        True,
    ),
    "anew: setext heading": (
        "Statics\n-------\n\nThe area moment is\n\n$$ J = a^4 $$\n\nFields\n------\n\nThe current "
        "density is $J$.\n\n$$ I = J A $$\n\nHence\n\n$$ I = a^4 A $$\n",
        False,
    ),
    "anew: setext heading with equals": (
        "Statics\n=======\n\nThe area moment is\n\n$$ J = a^4 $$\n\nFields\n======\n\nThe current "
        "density is $J$.\n\n$$ I = J A $$\n\nHence\n\n$$ I = a^4 A $$\n",
        False,
    ),
    "anew: HTML heading": (
        "<h2>Statics</h2>\n\nThe area moment is\n\n$$ J = a^4 $$\n\n<h2>Fields</h2>\n\nThe current "
        "density is $J$.\n\n$$ I = J A $$\n\nHence\n\n$$ I = a^4 A $$\n",
        False,
    ),
    "anew: block slide": (
        r"\begin{frame}\frametitle{A} The stress is \[ s = E e. \] \end{frame} "
        r"\begin{frame}\frametitle{B} With path length $s$ we get \[ v = \frac{s}{t}. \] So \[ v = "
        r"\frac{E e}{t}. \] \end{frame}",
        True,
    ),
    "anew: exercise environment": (
        r"The stress is \[ s = E e. \] \begin{exercise} A car covers the distance $s$. Then \[ v = "
        r"\frac{s}{t}. \] \end{exercise} Hence \[ v = \frac{E e}{t}. \]",
        True,
    ),
    "anew: reuse the letter": (
        r"\[ s = E e \] We now reuse the letter $s$ for the distance. \[ v = \frac{s}{t} \] Hence \[ v = "
        r"\frac{E e}{t}. \]",
        True,
    ),
    "anew: no longer": (
        r"\[ s = E e \] From this page on, $s$ no longer means the stress but the distance. \[ v = "
        r"\frac{s}{t} \] Hence \[ v = \frac{E e}{t}. \]",
        True,
    ),
    "anew: not to be confused": (
        r"\section{A} The stress is \[ s = E e. \] \section{B} \[ v = \frac{s}{t}, \] $s$ being the "
        r"distance. Hence \[ v = \frac{E e}{t}. \]",
        True,
    ),
    "range: for behind": (
        r"The tariff is \[ T(w) = a w \quad \text{for } w < 10. \] Hence \[ T(50) = 50 a. \]",
        True,
    ),
    "range: up to": (
        r"Up to the speed $v_1$ the drag is \[ D(v) = b v. \] Beyond it the flow is turbulent. Hence \[ "
        r"D(3 v_1) = 3 b v_1. \]",
        True,
    ),
    "range: as long as": (
        r"As long as the fuel lasts, \[ v(t) = a t. \] After burnout, hence \[ v(2 t) = 2 a t. \]",
        True,
    ),
    "range: in the first second": (
        r"In the first second, \[ x(t) = c t. \] In the fifth second, hence \[ x(t) - c t = 0. \]",
        True,
    ),
    "range: elastic region": (
        r"In the elastic region, \[ s = E e. \] In the plastic region, thus \[ s / E = e. \]",
        True,
    ),
    "range: below the threshold": (
        r"Below the threshold the cost is \[ C = a q. \] Above the threshold, hence \[ 2 C = 2 a q. \]",
        True,
    ),
    "range: recurrence ends": (
        r"\[ y_{j+1} = 3 y_j, \quad 0 \le j < M \] Hence \[ y_{M+2} = 3 y_{M+1}. \]",
        True,
    ),
    "range: recurrence for small j": (
        r"\[ y_{j+1} = 3 y_j \quad (j = 0, 1, 2) \] Hence \[ y_8 = 3 y_7. \]",
        True,
    ),
    "range: two columns of ranges": (
        r"\begin{align} f(x) &= x, & 0 < x < 1, \\ g(x) &= 2 x, & x > 1. \end{align} Hence \[ f(4) = 4. "
        r"\]",
        True,
    ),
    "range: outside the shell": (
        r"Outside the shell the field is \[ E(r) = \frac{k}{r^2}, \qquad r > R. \] Hence \[ E(R/2) = "
        r"\frac{4 k}{R^2}. \]",
        True,
    ),
    "range: triangle wave": (
        r"Let \[ w(x) = 1 - |x|, \quad -1 \le x \le 1, \] be continued with period two. Hence \[ w(4) = "
        r"-3. \]",
        True,
    ),
    "two: cold and hot side": (
        r"The cold side has \[ q = a T. \] The hot side has \[ q = b T. \] Hence \[ a T = b T. \]",
        True,
    ),
    "two: before and after by a dash": (
        "Before:\n\n$$ p = m v $$\n\nAfter:\n\n$$ p = m w $$\n\nHence\n\n$$ m v = m w $$\n",
        False,
    ),
    "two: items": (
        r"\begin{itemize}\item Short beam: \[ w = a F \] \item Long beam: \[ w = b F \] \end{itemize} "
        r"Hence \[ a F = b F. \]",
        True,
    ),
    "two: enumerated regimes": (
        "1. laminar\n\n$$ f = a u $$\n\n2. turbulent\n\n$$ f = b u $$\n\nHence\n\n$$ a u = b u $$\n",
        False,
    ),
    "two: Alice and Bob": (
        r"Alice computes \[ k = g a. \] Bob computes \[ k = g b. \] Hence \[ g a = g b. \]",
        True,
    ),
    "two: explicit and implicit": (
        r"The explicit scheme is \[ u_1 = u_0 + h f_0. \] The implicit scheme is \[ u_1 = u_0 + h f_1. "
        r"\] Hence \[ f_0 = f_1. \]",
        True,
    ),
    "two: estimators": (
        r"The first estimator is \[ \hat m = \frac{a + b}{2}. \] The second estimator is \[ \hat m = "
        r"\frac{a + 2 b}{3}. \] Hence \[ a = b. \]",
        True,
    ),
    "two: brass then": (
        r"Steel has \[ E = 3 c. \] Brass has \[ E = 2 c. \] The force of the steel wire is \[ F = E A e. "
        r"\] Hence \[ F = 2 c A e. \]",
        True,
    ),
    "two: third thing": (
        r"For steel, \[ E = 3 c. \] For brass, \[ E = 2 c. \] Then \[ F = E A. \] Hence for wood \[ F = "
        r"2 c A. \]",
        True,
    ),
    "two: upper and lower sums in rows": (
        r"The upper and lower sums read \begin{align} S &= h a \\ S &= h b \end{align} Hence \[ h a = h "
        r"b. \]",
        True,
    ),
    "two: in case A": (
        r"Case A: \[ z = x + y \] Case B: \[ z = x - y \] Hence \[ y = 0. \]",
        True,
    ),
    "two: player": (
        r"Player 1 earns \[ u = a x. \] Player 2 earns \[ u = b x. \] Hence \[ a x = b x. \]",
        True,
    ),
    "two: left and right frame": (
        r"In the left picture \[ x = f X. \] In the right picture \[ x = f X - f B. \] Hence \[ f B = 0. "
        r"\]",
        True,
    ),
    "act: truncated": (
        r"\[ s = a + b \] Then $s$ is truncated to an integer. \[ t = 2 s \] Hence \[ t = 2 a + 2 b. \]",
        True,
    ),
    "act: we negate": (
        r"\[ s = a + b \] We now negate $s$. \[ t = 2 s \] Hence \[ t = 2 a + 2 b. \]",
        True,
    ),
    "act: multiply in place": (
        r"\[ s = a + b \] Multiply $s$ in place by three. \[ t = 2 s \] Hence \[ t = 2 a + 2 b. \]",
        True,
    ),
    "act: increment": (
        "$$ s = a + b $$\n\nIncrement $s$.\n\n$$ t = 2 s $$\n\nHence\n\n$$ t = 2 a + 2 b $$\n",
        False,
    ),
    "act: a filter is applied to": (
        r"\[ s = a + b \] A filter is applied to $s$. \[ t = 2 s \] Hence \[ t = 2 a + 2 b. \]",
        True,
    ),
    "act: after smoothing": (
        r"\[ s = a + b \] After smoothing $s$ twice we use it: \[ t = 2 s \] Hence \[ t = 2 a + 2 b. \]",
        True,
    ),
    "act: letter grows per year": (
        r"The rate $r$ rises by one percent each year. \[ K_{n+1} = K_n + r \] Hence \[ K_{n+2} = K_n + "
        r"2 r. \]",
        True,
    ),
    "act: letter gets smaller": (
        r"The damping $c$ gets smaller at every pass. \[ x_{n+1} = c x_n \] Hence \[ x_{n+2} = c^2 x_n. "
        r"\]",
        True,
    ),
    "act: drawn anew": (
        r"In every round a new $c$ is drawn. \[ x_{n+1} = c + x_n \] Hence \[ x_{n+2} = 2 c + x_n. \]",
        True,
    ),
    "act: algorithm overwrites": (
        r"\[ s = a + b \] Overwrite $s$ with its square root. \[ t = 2 s \] Hence \[ t = 2 a + 2 b. \]",
        True,
    ),
    "act: by convention sign flips": (
        r"\[ s = a + b \] From now on we count $s$ downwards. \[ t = 2 s \] Hence \[ t = 2 a + 2 b. \]",
        True,
    ),
    "act: units change": (
        r"With lengths in metres, \[ L = 1000 k. \] We convert $L$ to millimetres. \[ A = L b \] Hence "
        r"\[ A = 1000 k b. \]",
        True,
    ),
    "act: h halves itself": (
        r"The step $h$ halves whenever the error is large. \[ t_{i+1} = t_i + h \] Hence \[ t_{i+2} = "
        r"t_i + 2 h. \]",
        True,
    ),
    "act: someone else": (
        r"\[ s = a + b \] The controller then resets $s$. \[ t = 2 s \] Hence \[ t = 2 a + 2 b. \]",
        True,
    ),
    "anew: theorem in between": (
        r"\section{Norms} Its norm is \[ n = a^2 + b^2. \] \section{Rays} A ray enters a medium of "
        r"refractive index $n$: \[ c = n v. \] Therefore \[ c = a^2 v + b^2 v. \]",
        True,
    ),
    "anew: same section, two nouns": (
        r"The tension is \[ T = m g. \] The temperature $T$ of the rope sets \[ L = a T. \] Thus \[ L = "
        r"a m g. \]",
        True,
    ),
    "anew: denote by": (
        r"The tension is \[ T = m g. \] We denote by $T$ the temperature of the rope. \[ L = a T \] Thus "
        r"\[ L = a m g. \]",
        True,
    ),
    "anew: where list in md": (
        "## Rope\n\nThe tension is\n\n$$ T = m g $$\n\n## Heat\n\n$$ L = a T $$\n\nwhere\n\n* $L$ is "
        "the length and\n* $T$ the temperature.\n\nThus\n\n$$ L = a m g $$\n",
        False,
    ),
    "anew: equals sign in a list": (
        "## Rope\n\nThe tension is\n\n$$ T = m g $$\n\n## Heat\n\n- $T$ = temperature\n- $L$ = length\n\n"
        "$$ L = a T $$\n\nThus\n\n$$ L = a m g $$\n",
        False,
    ),
    "anew: standing for": (
        r"\section{Rope} The tension is \[ T = m g. \] \section{Heat} With $T$ standing for temperature, "
        r"\[ L = a T. \] Thus \[ L = a m g. \]",
        True,
    ),
    "anew: respectively": (
        r"\section{Rope} The tension is \[ T = m g. \] \section{Heat} Length and temperature are $L$ and "
        r"$T$, respectively. \[ L = a T \] Thus \[ L = a m g. \]",
        True,
    ),
    "anew: unit in brackets": (
        "## Rope\n\nThe tension is\n\n$$ T = m g $$\n\n## Heat\n\n$T$ [K] temperature, $L$ [m] length.\n"
        "\n$$ L = a T $$\n\nThus\n\n$$ L = a m g $$\n",
        False,
    ),
    "anew: at temperature": (
        r"\section{Rope} The tension is \[ T = m g. \] \section{Heat} At temperature $T$ its length is "
        r"\[ L = a T. \] Thus \[ L = a m g. \]",
        True,
    ),
    "anew: as a function of": (
        r"\section{Rope} The tension is \[ T = m g. \] \section{Heat} As a function of temperature $T$ "
        r"the length is \[ L = a T. \] Thus \[ L = a m g. \]",
        True,
    ),
    "anew: for constant": (
        r"\section{Rope} The tension is \[ T = m g. \] \section{Heat} For constant temperature $T$ the "
        r"length is \[ L = a T. \] Thus \[ L = a m g. \]",
        True,
    ),
    "anew: tabular reversed": (
        "## Rope\n\nThe tension is\n\n$$ T = m g $$\n\n## Heat\n\n| quantity | symbol |\n|---|---|\n| "
        "temperature | $T$ |\n| length | $L$ |\n\n$$ L = a T $$\n\nThus\n\n$$ L = a m g $$\n",
        False,
    ),
    "range: on the interval": (
        r"On the interval $[0, 1]$ let \[ f(x) = x^2. \] Hence \[ f(6) = 36. \]",
        True,
    ),
    "range: for positive x": (
        r"For positive $x$ let \[ f(x) = x. \] Hence \[ f(-6) = -6. \]",
        True,
    ),
    "range: between": (
        r"Between $x = 0$ and $x = L$ the moment is \[ M(x) = F x. \] Hence \[ M(2 L) = 2 F L. \]",
        True,
    ),
    "range: cases display": (
        r"\[ f(x) = \begin{cases} x & x < 1 \\ 1 & x \ge 1 \end{cases} \] Hence \[ f(6) = 6. \]",
        True,
    ),
    "range: with words": (
        r"The law \[ \sigma(e) = E e, \qquad |e| \le e_y, \] holds for small strains. Hence \[ \sigma(2 "
        r"e_y) = 2 E e_y. \]",
        True,
    ),
    "range: valid for": (
        r"The law \[ p(h) = a h \] is valid for $h < 10$. Hence \[ p(30) = 30 a. \]",
        True,
    ),
    "range: only on": (
        r"\[ p(h) = a h \] This is valid only for $h < 10$. Hence \[ p(30) = 30 a. \]",
        True,
    ),
    "range: a letter not a function": (
        r"\[ p = a h, \quad 0 < h < 10 \] At $h = 30$ thus \[ p = 30 a. \]",
        True,
    ),
    "range: index of a product": (
        r"\[ a_{n+1} = 2 a_n, \qquad n < 5 \] Hence \[ a_9 = 2 a_8. \]",
        True,
    ),
    "two: night and day": (
        r"By day the flux is \[ q = a s. \] By night the flux is \[ q = b s. \] Hence \[ a s = b s. \]",
        True,
    ),
    "two: town names": (
        r"In Berlin \[ p = a c. \] In Paris \[ p = b c. \] Hence \[ a c = b c. \]",
        True,
    ),
    "two: table rows": (
        r"The two roots are \begin{align} x &= a + d, \\ x &= a - d. \end{align} Hence \[ d = 0. \]",
        True,
    ),
    "two: gather of models": (
        r"The competing models read \begin{gather} y = a x \\ y = b x \end{gather} Hence \[ a x = b x. \]",
        True,
    ),
    "two: either or": (
        r"Either \[ x = 3 a \] or \[ x = 5 a. \] Hence \[ a = 0. \]",
        True,
    ),
    "two: old value returns": (
        r"For gas \[ c = 3 r. \] For oil \[ c = 5 r. \] The heat is \[ Q = c m. \] For gas it is \[ Q = "
        r"5 r m. \]",
        True,
    ),
    "two: the gas burner": (
        r"The gas has \[ c = 3 r. \] The oil has \[ c = 5 r. \] The heat of the gas is \[ Q = c m. \] So "
        r"\[ Q = 5 r m. \]",
        True,
    ),
    "two: vectors": (
        r"At station A \[ \mathbf{u} = a \mathbf{e}. \] At station B \[ \mathbf{u} = b \mathbf{e}. \] "
        r"Hence \[ a \mathbf{e} = b \mathbf{e}. \]",
        True,
    ),
    "two: run 1 and run 2": (
        "Run 1:\n\n$$ z = a t $$\n\nRun 2:\n\n$$ z = b t $$\n\nHence\n\n$$ a t = b t $$\n",
        False,
    ),
    "two: worst and best": (
        r"In the worst case \[ z = a t. \] In the best case \[ z = b t. \] Hence \[ a t = b t. \]",
        True,
    ),
    "two: yesterday today": (
        r"Yesterday \[ z = a t. \] Today \[ z = b t. \] Hence \[ a t = b t. \]",
        True,
    ),
    "act: rotate the frame": (
        r"\[ x = a + b \] The axis of $x$ is then reversed. \[ y = 2 x \] Hence \[ y = 2 a + 2 b. \]",
        True,
    ),
    "act: letter list": (
        r"\[ x = a + b \] Now $x$, $y$ and $z$ are rounded. \[ w = 2 x \] Hence \[ w = 2 a + 2 b. \]",
        True,
    ),
    "act: square each": (
        r"\[ x = a + b \] Squaring $x$ in place, we go on with \[ w = 2 x. \] Hence \[ w = 2 a + 2 b. \]",
        True,
    ),
    "act: swap": (
        r"\[ x = a + b \] Swap $x$ and $y$. \[ w = 2 x \] Hence \[ w = 2 a + 2 b. \]",
        True,
    ),
    "act: we then let grow": (
        r"\[ x = a + b \] We then let $x$ grow by ten percent. \[ w = 2 x \] Hence \[ w = 2 a + 2 b. \]",
        True,
    ),
    "act: in the loop": (
        r"In each loop $c$ is multiplied by two. \[ x_{k+1} = x_k + c \] Hence \[ x_{k+2} = x_k + 2 c. \]",
        True,
    ),
    "act: c depends on step in words": (
        r"The gain $c$ differs from step to step. \[ x_{k+1} = x_k + c \] Hence \[ x_{k+2} = x_k + 2 c. "
        r"\]",
        True,
    ),
    "act: c is random": (
        r"Each $c$ comes from a die. \[ x_{k+1} = x_k + c \] Hence \[ x_{k+2} = x_k + 2 c. \]",
        True,
    ),
    "anew: in English sentence": (
        r"\section{Soil} The porosity follows from \[ \phi = a / b. \] \section{Flow} Consider a plate "
        r"at the potential $\phi$. The charge is \[ q = C \phi. \] Consequently \[ q = C a / b. \]",
        True,
    ),
    "anew: capital of a function": (
        r"\section{Gas} \[ H = U + p V \] is the enthalpy. \section{Magnets} A coil makes a field $H$ "
        r"with \[ B = \mu H. \] Consequently \[ B = \mu (U + p V). \]",
        True,
    ),
    "anew: whose": (
        r"\section{Gas} The enthalpy is \[ H = U + p V. \] \section{Houses} A house whose height is $H$ "
        r"casts \[ s = 2 H. \] Consequently \[ s = 2 U + 2 p V. \]",
        True,
    ),
    "anew: having": (
        "## Gas\n\nThe enthalpy is\n\n$$ H = U + p V $$\n\n## Houses\n\nA house having height $H$ casts\n"
        "\n$$ s = 2 H $$\n\nConsequently\n\n$$ s = 2 U + 2 p V $$\n",
        False,
    ),
    "anew: measured height": (
        "## Gas\n\nThe enthalpy is\n\n$$ H = U + p V $$\n\n## Houses\n\nFirst measure the height, $H$. "
        "The shadow is\n\n$$ s = 2 H $$\n\nConsequently\n\n$$ s = 2 U + 2 p V $$\n",
        False,
    ),
    "anew: bullet with colon in bold": (
        "## Gas\n\nThe enthalpy is\n\n$$ H = U + p V $$\n\n## Houses\n\n* **$H$**: height\n* **$s$**: "
        "shadow\n\n$$ s = 2 H $$\n\nConsequently\n\n$$ s = 2 U + 2 p V $$\n",
        False,
    ),
    "anew: footnote": (
        r"\section{Gas} The enthalpy is \[ H = U + p V. \] \section{Houses} The shadow is \[ s = 2 "
        r"H.\footnote{$H$ is the height.} \] Consequently \[ s = 2 U + 2 p V. \]",
        True,
    ),
    "anew: caption": (
        r"\section{Gas} The enthalpy is \[ H = U + p V. \] \section{Houses} \begin{figure}\caption{House "
        r"of height $H$.}\end{figure} \[ s = 2 H \] Consequently \[ s = 2 U + 2 p V. \]",
        True,
    ),
    "range: until": (
        r"The tank fills as \[ V(t) = q t \] until $t = T$. Consequently \[ V(3 T) = 3 q T. \]",
        True,
    ),
    "range: while it is in the air": (
        r"While the ball is in the air, \[ y(t) = u t - g t^2. \] On the ground, consequently \[ y(t) - "
        r"u t = -g t^2. \]",
        True,
    ),
    "range: interpolation": (
        r"The interpolant on $[x_0, x_1]$ is \[ p(x) = a + b x. \] Consequently \[ p(x_1 + 5) = a + b "
        r"x_1 + 5 b. \]",
        True,
    ),
    "range: unit disc": (
        r"\[ f(r) = 1 - r^2 \qquad (r < 1) \] Consequently \[ f(3) = -8. \]",
        True,
    ),
    "range: where in text below": (
        r"\[ f(r) = 1 - r^2 \] Here, $r < 1$. Consequently \[ f(3) = -8. \]",
        True,
    ),
    "range: t from 0 to T": (
        r"For $t$ from $0$ to $T$ the dose is \[ d(t) = k t. \] Consequently \[ d(4 T) = 4 k T. \]",
        True,
    ),
    "two: firms": (
        r"Firm A makes \[ y = a k. \] Firm B makes \[ y = b k. \] Consequently \[ a k = b k. \]",
        True,
    ),
    "two: summer": (
        r"In the dry season \[ y = a k. \] In the wet season \[ y = b k. \] Consequently \[ a k = b k. \]",
        True,
    ),
    "two: primary secondary": (
        r"The primary coil has \[ U = a n. \] The secondary coil has \[ U = b n. \] Consequently \[ a n "
        r"= b n. \]",
        True,
    ),
    "two: method names": (
        r"Euler's method gives \[ u = v + h w. \] Heun's method gives \[ u = v + h w + h^2 z. \] "
        r"Consequently \[ h^2 z = 0. \]",
        True,
    ),
    "two: maximum and minimum": (
        r"The maximum is \[ y = a + b. \] The minimum is \[ y = a - b. \] Consequently \[ b = 0. \]",
        True,
    ),
    "two: upper sign": (
        r"For protons \[ F = e E. \] For electrons \[ F = -e E. \] Consequently \[ 2 e E = 0. \]",
        True,
    ),
    "act: sorted": (
        r"\[ x = a + b \] The vector entries $x$ are then sorted. \[ y = 3 x \] Consequently \[ y = 3 a "
        r"+ 3 b. \]",
        True,
    ),
    "act: clip": (
        "$$ x = a + b $$\n\nWe clip $x$ to the unit interval.\n\n$$ y = 3 x $$\n\nConsequently\n\n$$ y "
        "= 3 a + 3 b $$\n",
        False,
    ),
    "act: now takes": (
        r"\[ x = a + b \] Now $x$ takes the value seven. \[ y = 3 x \] Consequently \[ y = 3 a + 3 b. \]",
        True,
    ),
    "act: schedule": (
        r"The rate $g$ follows a schedule. \[ x_{k+1} = x_k + g \] Consequently \[ x_{k+2} = x_k + 2 g. "
        r"\]",
        True,
    ),
    "act: warm up": (
        r"We lower $g$ every epoch. \[ x_{k+1} = x_k + g \] Consequently \[ x_{k+2} = x_k + 2 g. \]",
        True,
    ),
    "act: line search": (
        r"A line search picks $g$ at each iterate. \[ x_{k+1} = x_k + g \] Consequently \[ x_{k+2} = x_k "
        r"+ 2 g. \]",
        True,
    ),
    "act: depends on": (
        r"The rate $g$ depends on the step. \[ x_{k+1} = x_k + g \] Consequently \[ x_{k+2} = x_k + 2 g. "
        r"\]",
        True,
    ),
}
STEADY = {
    "act: replaced in an equation": (
        r"\[ a = b + c \] Now, if you replace $a$ from (8) into (9), then \[ d = a - c. \] Hence \[ d = b. \]",
        True,
    ),
    "act: each point": (
        r"We have each point $x_i$ and $y$. \[ y = \frac{1}{n} \sum_{i=1}^n x_i \] "
        r"Hence \[ \sum_{i=1}^n (x_i - y) = 0. \]",
        True,
    ),
    "anew: a solution": (
        r"\section{Law} The law is \[ M a = g. \] \section{Rates} The mathematical solution is \[ a = \frac{g}{M}. \]",
        True,
    ),
    "anew: what surrounds": (
        r"\section{Grid} The law is \[ u_0 = 4 h. \] \section{Points} The points surrounding $u_0$ obey "
        r"\[ v = u_0 + h. \] Hence \[ v = 5 h. \]",
        True,
    ),
    "context: two-dimensional": (
        r"The law is \[ s = a + b. \] For a two-dimensional problem we need a way. Hence \[ s - a = b. \]",
        True,
    ),
    "context: in this example": (
        r"The law is \[ s = a + b. \] In this example we check it. Hence \[ s - a = b. \]",
        True,
    ),
    "anew: same noun": (
        r"\section{Diffusion} The diffusivity is \[ D = \frac{l^2}{t}. \] \section{Mass flow} With the "
        r"diffusivity $D$ the flow is \[ J = D g. \] Thus \[ J = \frac{l^2 g}{t}. \]",
        True,
    ),
    "anew: no words": (
        r"\section{Diffusion} The diffusivity is \[ D = \frac{l^2}{t}. \] \section{Mass flow} We have \[ "
        r"J = D g. \] Thus \[ J = \frac{l^2 g}{t}. \]",
        True,
    ),
    "anew: paragraph continues": (
        r"\paragraph{Beam.} Its inertia is \[ I = b h^3. \] \paragraph{Deflection.} The deflection is \[ "
        r"w = \frac{F}{I}. \] So \[ w b h^3 = F. \]",
        True,
    ),
    "anew: symbol in brackets": (
        "# Charge\n\nThe charge is\n\n$$ q = k g $$\n\n# Force\n\nThe charge ($q$) sets the force\n\n$$ "
        "F = q E $$\n\nso that\n\n$$ F = k g E $$\n",
        False,
    ),
    "anew: other letters described": (
        r"\section{A} The slope is \[ m = \frac{y}{x}. \] \section{B} With the force $F$ and the time "
        r"$t$, \[ p = m F t. \] Hence \[ p = \frac{y F t}{x}. \]",
        True,
    ),
    "anew: cited": (
        r"\section{A} The slope is \[ m = \frac{y}{x}. \] \section{B} The slope $m$ gives \[ c = 2 m. \] "
        r"Hence \[ c = \frac{2 y}{x}. \]",
        True,
    ),
    "anew: slides go on": (
        r"\begin{frame}{A} The stress is \[ s = E e. \] \end{frame} \begin{frame}{B} The force is \[ F = "
        r"s A. \] So \[ F = E e A. \] \end{frame}",
        True,
    ),
    "anew: rule in Markdown": (
        "The stress is\n\n$$ s = E e $$\n\n---\n\nThe force is\n\n$$ F = s A $$\n\nSo\n\n$$ F = E e A $$\n",
        False,
    ),
    "anew: generic noun": (
        r"\section{A} The gain is \[ k = a b. \] \section{B} The parameter $k$ gives \[ u = k e. \] So "
        r"\[ u = a b e. \]",
        True,
    ),
    "range: inside": (
        r"The tariff is \[ T(w) = a w, \quad 0 < w < 10. \] Hence \[ T(5) = 5 a. \]",
        True,
    ),
    "range: shift of a line": (
        r"\[ f(x) = 2 x, \quad x > 0 \] Hence \[ f(x + 1) = 2 x + 2. \]",
        True,
    ),
    "range: derivative": (
        r"\[ f(x) = x^2, \quad 0 < x < 1 \] Hence \[ f'(x) = 2 x. \]",
        True,
    ),
    "range: as itself": (
        r"\[ y = b s, \quad s > 0 \] Hence \[ y^2 = b^2 s^2. \]",
        True,
    ),
    "range: positive constants": (
        r"Let \[ E = a b, \quad a > 0, \; b > 0. \] Hence \[ E^2 = a^2 b^2. \]",
        True,
    ),
    "range: outside the shell": (
        r"Outside the shell the field is \[ E(r) = \frac{k}{r^2}, \qquad r > R. \] Hence \[ E(2 R) = "
        r"\frac{k}{4 R^2}. \]",
        True,
    ),
    "range: below, and then": (
        r"Below the threshold the cost is \[ C = a q. \] Hence \[ 2 C = 2 a q. \]",
        True,
    ),
    "range: elastic": (
        r"In the elastic region, \[ s = E e. \] Thus \[ s / E = e. \]",
        True,
    ),
    "two: same thing twice": (
        r"For steel, \[ E = 3 c. \] The stress is \[ s = E d. \] Hence for steel \[ s = 3 c d. \]",
        True,
    ),
    "two: brass": (
        r"Steel has \[ E = 3 c. \] Brass has \[ E = 2 c. \] The force of the brass wire is \[ F = E A e. "
        r"\] Hence \[ F = 2 c A e. \]",
        True,
    ),
    "two: two laws": (
        r"By Hooke's law, \[ F = -k x. \] By Newton's law, \[ F = m a. \] Hence \[ m a = -k x. \]",
        True,
    ),
    "two: frames": (
        r"In frame one, \[ x = a + b. \] Hence in frame one \[ x - a = b. \]",
        True,
    ),
    "two: after some steps": (
        r"After some algebra, \[ s = a + b. \] After squaring, \[ s^2 = a^2 + 2 a b + b^2. \]",
        True,
    ),
    "two: for brevity": (
        r"For brevity, \[ s = a + b. \] For comparison, \[ 2 s = 2 a + 2 b. \]",
        True,
    ),
    "two: first and second line": (
        r"In the first line \[ s = a + b. \] In the second line \[ t = 2 s. \] Hence \[ t = 2 a + 2 b. \]",
        True,
    ),
    "two: model": (
        r"Model 2: \[ y = a x. \] For model 2 we thus have \[ 2 y = 2 a x. \]",
        True,
    ),
    "act: we know": (
        r"\[ s = a + b \] We measured $s$ twice. \[ t = 2 s \] Hence \[ t = 2 a + 2 b. \]",
        True,
    ),
    "act: is called": (
        r"\[ s = a + b \] Here $s$ is called the sum. \[ t = 2 s \] Hence \[ t = 2 a + 2 b. \]",
        True,
    ),
    "act: plays a role": (
        r"\[ s = a + b \] The sum $s$ plays a role below. \[ t = 2 s \] Hence \[ t = 2 a + 2 b. \]",
        True,
    ),
    "act: substitute": (
        r"\[ s = a + b \] We substitute $s$ in \[ t = 2 s. \] Hence \[ t = 2 a + 2 b. \]",
        True,
    ),
    "act: solve for": (
        r"\[ 2 s = a + b \] We solve for $s$. \[ s = \frac{a + b}{2} \]",
        True,
    ),
    "act: multiply by": (
        r"\[ s = a + b \] We multiply by $s$. \[ s^2 = s a + s b \]",
        True,
    ),
    "act: constant step": (
        r"The step $h$ is constant. \[ x_{k+1} = x_k + h \] Hence \[ x_{k+2} = x_k + 2 h. \]",
        True,
    ),
    "act: another letter": (
        r"\[ s = a + b \] Then $c$ is doubled. \[ t = 2 s \] Hence \[ t = 2 a + 2 b. \]",
        True,
    ),
    "act: eliminate": (
        r"\[ s = a + b \] To eliminate $s$, write \[ t = 2 s. \] Hence \[ t = 2 a + 2 b. \]",
        True,
    ),
    "act: note that s contains": (
        r"\[ s = a + b \] Note that $s$ contains both. \[ t = 2 s \] Hence \[ t = 2 a + 2 b. \]",
        True,
    ),
    "same noun in another section": (
        r"\section{Rope} The tension is \[ T = m g. \] \section{Heat} The tension $T$ warms it: \[ L = a "
        r"T. \] Thus \[ L = a m g. \]",
        True,
    ),
    "description after": (
        r"The tension is \[ T = m g, \] where $m$ is the mass and $g$ is the gravity. With the length \[ "
        r"L = a T, \] we get \[ L = a m g. \]",
        True,
    ),
    "synonyms by cite": (
        r"\section{Rope} \[ T = m g \tag{1} \] \section{Heat} By (1) \[ L T = L m g. \]",
        True,
    ),
    "two descriptions alike": (
        r"Let $T$ be the tension of the rope, \[ T = m g. \] The rope tension $T$ gives \[ L = a T. \] "
        r"Thus \[ L = a m g. \]",
        True,
    ),
    "described before it is given": (
        r"The rope has a tension $T$. It is found from \[ T = m g. \] The tension $T$ stretches it by \[ "
        r"L = a T. \] Thus \[ L = a m g. \]",
        True,
    ),
    "in range words": (
        r"For $x > 0$ let \[ f(x) = x^2. \] Hence for $x > 0$ \[ f(x) - x^2 = 0. \]",
        True,
    ),
    "in range letter": (
        r"\[ p = a h, \quad 0 < h < 10 \] With $h = 3$ thus \[ p = 3 a. \]",
        True,
    ),
    "double inside": (
        r"\[ f(x) = x^2, \quad 0 \le x \le 1 \] Hence \[ f(1/2) + f(1) = \frac54. \]",
        True,
    ),
    "chained functions": (
        r"\[ g(x) = f(x) + 1 \] \[ f(x) = x^2, \quad x \ge 0 \] Hence \[ g(2) = 5. \]",
        True,
    ),
    "negative range": (
        r"\[ f(x) = -x, \quad x < 0 \] Hence \[ f(-2) = 2. \]",
        True,
    ),
    "range of angle": (
        r"\[ y = r \sin\theta, \quad 0 \le \theta \le \pi \] Hence \[ y^2 = r^2 \sin^2\theta. \]",
        True,
    ),
    "index range": (
        r"\[ a_{n+1} = 2 a_n, \qquad n \ge 0 \] Hence \[ a_9 = 2 a_8. \]",
        True,
    ),
    "same place": (
        r"In Berlin \[ p = a c. \] In Berlin, hence \[ 2 p = 2 a c. \]",
        True,
    ),
    "place then general": (
        r"In practice, \[ p = a c. \] In general, \[ q = 2 p. \] Hence \[ q = 2 a c. \]",
        True,
    ),
    "during step": (
        r"In the first step, \[ s = a + b. \] In the second step, \[ t = 2 s. \] Hence \[ t = 2 a + 2 b. "
        r"\]",
        True,
    ),
    "in matrix form": (
        r"In scalar form, \[ s = a + b. \] In compact form, \[ 2 s = 2 a + 2 b. \]",
        True,
    ),
    "gas again": (
        r"For gas \[ c = 3 r. \] The heat is \[ Q = c m. \] For gas it is \[ Q = 3 r m. \]",
        True,
    ),
    "rows as steps": (
        r"We have \begin{align} s &= a + b \\ t &= 2 s \end{align} Hence \[ t = 2 a + 2 b. \]",
        True,
    ),
    "equations of motion": (
        r"The equations of motion are \begin{align} F &= m a \\ F &= -k x \end{align} Hence \[ m a = -k "
        r"x. \]",
        True,
    ),
    "letter given": (
        r"\[ x = a + b \] Here $x$ is given in metres. \[ y = 2 x \] Hence \[ y = 2 a + 2 b. \]",
        True,
    ),
    "letter known": (
        r"\[ x = a + b \] Once $x$ is known, we can find \[ y = 2 x. \] Hence \[ y = 2 a + 2 b. \]",
        True,
    ),
    "letter enters": (
        r"\[ x = a + b \] The length $x$ enters as \[ y = 2 x. \] Hence \[ y = 2 a + 2 b. \]",
        True,
    ),
    "letter found": (
        r"\[ x = a + b \] Then we compute $y$ from $x$ by \[ y = 2 x. \] Hence \[ y = 2 a + 2 b. \]",
        True,
    ),
    "letter insert": (
        r"\[ x = a + b \] \[ y = 2 x \] Inserting $x$ we get \[ y = 2 a + 2 b. \]",
        True,
    ),
    "letter replace": (
        r"\[ x = a + b \] \[ y = 2 x \] Replacing $x$ we get \[ y = 2 a + 2 b. \]",
        True,
    ),
    "letter put in": (
        r"\[ x = a + b \] \[ y = 2 x \] We put $x$ into this: \[ y = 2 a + 2 b. \]",
        True,
    ),
    "plug in": (
        r"\[ x = a + b \] \[ y = 2 x \] When we plug in $x$, we find \[ y = 2 a + 2 b. \]",
        True,
    ),
    "h stays": (
        r"The gain $c$ stays the same at all steps. \[ x_{k+1} = x_k + c \] Hence \[ x_{k+2} = x_k + 2 "
        r"c. \]",
        True,
    ),
    "h given": (
        r"Let $c$ be a number. \[ x_{k+1} = x_k + c \] Hence \[ x_{k+2} = x_k + 2 c. \]",
        True,
    ),
}


@pytest.mark.parametrize("name", CHANGING)
def test_what_has_changed_proves_nothing(name: str) -> None:
    text, latex = CHANGING[name]
    assert read_document(document_of(text, latex=latex), seconds=5)[-1].verdict != "follows"


@pytest.mark.parametrize("name", STEADY)
def test_what_has_not_changed_proves_what_it_did(name: str) -> None:
    text, latex = STEADY[name]
    assert read_document(document_of(text, latex=latex), seconds=5)[-1].verdict == "follows"
