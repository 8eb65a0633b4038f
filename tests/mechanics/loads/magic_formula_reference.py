"""The Magic Formula in plain numbers, written from Pacejka (2012), Tire and Vehicle Dynamics, 3rd edition,
section 4.3.2, equations 4.E1 to 4.E78, without turn slip.

Writes magic_formula_reference.hpp, with which tyre_laws_test.cpp compares. `smooth` selects the roundings
that the library documents; without them, the equations are those of the book. The last column of each case
is the largest difference between the two, relative to the load or the load times the radius.
"""

import math
import random

NAMES = """Fz0 R0 V0
pCx1 pDx1 pDx2 pDx3 pEx1 pEx2 pEx3 pEx4 pKx1 pKx2 pKx3 pHx1 pHx2 pVx1 pVx2 ppx1 ppx2 ppx3 ppx4
rBx1 rBx2 rBx3 rCx1 rEx1 rEx2 rHx1
pCy1 pDy1 pDy2 pDy3 pEy1 pEy2 pEy3 pEy4 pEy5 pKy1 pKy2 pKy3 pKy4 pKy5 pKy6 pKy7 pHy1 pHy2
pVy1 pVy2 pVy3 pVy4 ppy1 ppy2 ppy3 ppy4 ppy5
rBy1 rBy2 rBy3 rBy4 rCy1 rEy1 rEy2 rHy1 rHy2 rVy1 rVy2 rVy3 rVy4 rVy5 rVy6
qBz1 qBz2 qBz3 qBz5 qBz6 qBz9 qBz10 qCz1 qDz1 qDz2 qDz3 qDz4 qDz6 qDz7 qDz8 qDz9 qDz10 qDz11
qEz1 qEz2 qEz3 qEz4 qEz5 qHz1 qHz2 qHz3 qHz4 ppz1 ppz2 ssz1 ssz2 ssz3 ssz4
qsx1 qsx2 qsx3 qsx4 qsx5 qsx6 qsx7 qsx8 qsx9 qsx10 qsx11 ppMx1
qsy1 qsy2 qsy3 qsy4 qsy5 qsy6 qsy8
pressure nominal_pressure qsy7
lambda_Fz0 lambda_mux lambda_muy lambda_Kxkappa lambda_Kyalpha lambda_Cx lambda_Cy lambda_Ex lambda_Ey
lambda_Hx lambda_Hy lambda_Vx lambda_Vy lambda_Kygamma lambda_Kzgamma lambda_t lambda_Mr lambda_xalpha
lambda_ykappa lambda_Vykappa lambda_s lambda_Mx lambda_VMx lambda_My""".split()

# A radial tyre of a passenger car, with coefficients of the usual size.
CAR = dict(
    Fz0=4000, R0=0.313, V0=16.7,
    pCx1=1.685, pDx1=1.210, pDx2=-0.037, pDx3=0.4, pEx1=0.344, pEx2=0.095, pEx3=-0.020, pEx4=0.03,
    pKx1=21.51, pKx2=-0.163, pKx3=0.245, pHx1=-0.002, pHx2=0.002, pVx1=0.001, pVx2=0.0005,
    rBx1=12.35, rBx2=-10.77, rBx3=2.0, rCx1=1.092, rEx1=0.3, rEx2=-0.1, rHx1=0.007,
    pCy1=1.193, pDy1=-0.990, pDy2=0.145, pDy3=-11.23, pEy1=-1.003, pEy2=-0.537, pEy3=-0.083, pEy4=-4.787,
    pKy1=-14.95, pKy2=2.130, pKy3=-0.028, pKy4=2, pKy6=-0.92, pKy7=-0.24, pHy1=0.003, pHy2=-0.001,
    pVy1=0.045, pVy2=-0.024, pVy3=-0.532, pVy4=0.039,
    rBy1=6.461, rBy2=4.196, rBy3=-0.015, rCy1=1.081, rHy1=0.009,
    rVy1=0.053, rVy2=-0.073, rVy3=0.517, rVy4=35.44, rVy5=1.9, rVy6=-10.71,
    qBz1=8.964, qBz2=-1.106, qBz3=-0.842, qBz5=-0.227, qBz9=18.47, qCz1=1.180, qDz1=0.100, qDz2=-0.001,
    qDz3=0.007, qDz4=13.05, qDz6=-0.008, qDz7=0.000, qDz8=-0.296, qDz9=-0.009,
    qEz1=-1.609, qEz2=-0.359, qEz4=0.174, qEz5=-0.896, qHz1=0.007, qHz2=-0.002, qHz3=0.147, qHz4=0.004,
    ssz1=0.043, ssz2=0.001, ssz3=0.731, ssz4=-0.238,
    qsx2=0.6, qsx3=0.05, qsx4=2.0, qsx5=1.1, qsx6=0.7, qsx7=0.6, qsx8=0.05, qsx9=0.8, qsx10=0.1, qsx11=0.9,
    qsy1=0.007, qsy2=0.001, qsy3=0.002, qsy4=0.0001, qsy7=0.9)
ZERO_OR_ONE = {n: 1.0 if n.startswith("lambda") or n in ("pressure", "nominal_pressure", "qsy7") else 0.0
               for n in NAMES}


def complete(some):
    return {**ZERO_OR_ONE, **some}


def every_term():
    """All coefficients differ from zero and from each other."""
    source = random.Random(12)
    c = complete(CAR)
    for n in NAMES[3:]:
        if c[n] == 0:
            c[n] = source.uniform(0.02, 0.2)
        else:
            c[n] *= source.uniform(0.9, 1.1)
    return c


class Tyre:
    def __init__(self, c, smooth, standstill=0.05):
        self.__dict__.update(c)
        self.smooth, self.v0 = smooth, standstill

    def sgn(self, x):
        return x / math.hypot(x, 1e-6) if self.smooth else math.copysign(1, x)

    def mag(self, x):
        return x * x / math.hypot(x, 1e-3) if self.smooth else abs(x)

    def cap(self, e):
        if not self.smooth:
            return min(e, 1)
        x, w = 1.05 - e, 0.1
        t = min(max(x / w, 0), 1)
        return 1 - (w * t**3 * (1 - t / 2) if x < w else x - w / 2)

    @staticmethod
    def curve(b, c, e, x):
        return c * math.atan(b * x - e * (b * x - math.atan(b * x)))

    def at(self, Fz, kappa, alpha, gamma, V):
        """alpha is tan alpha and gamma is sin gamma, as 4.E3 and 4.E4 define them."""
        n = self.lambda_Fz0 * self.Fz0
        df = (Fz - n) / n
        dp = (self.pressure - self.nominal_pressure) / self.nominal_pressure
        direction = V / math.hypot(V, self.v0) if self.smooth else math.copysign(1, V)
        ca = direction / math.hypot(1, alpha)
        amu = lambda l: 10 * l / (1 + 9 * l)
        tiny = 1e-9 * n if self.smooth else 0.0
        # longitudinal force, pure slip
        Kx = (Fz * (self.pKx1 + self.pKx2 * df) * math.exp(self.pKx3 * df)
              * (1 + self.ppx1 * dp + self.ppx2 * dp**2) * self.lambda_Kxkappa)
        mux = ((self.pDx1 + self.pDx2 * df) * (1 + self.ppx3 * dp + self.ppx4 * dp**2)
               * (1 - self.pDx3 * gamma**2) * self.lambda_mux)
        Cx, Dx = self.pCx1 * self.lambda_Cx, mux * Fz
        Bx = Kx / (Cx * Dx + tiny)
        kx = kappa + (self.pHx1 + self.pHx2 * df) * self.lambda_Hx
        Ex = self.cap((self.pEx1 + self.pEx2 * df + self.pEx3 * df**2) * (1 - self.pEx4 * self.sgn(kx))
                      * self.lambda_Ex)
        SVx = Fz * (self.pVx1 + self.pVx2 * df) * self.lambda_Vx * amu(self.lambda_mux)
        if self.smooth:
            SVx *= V * V / (V * V + self.v0**2)
        Fxo = Dx * math.sin(self.curve(Bx, Cx, Ex, kx)) + SVx
        # longitudinal force, combined slip
        Bxa = (self.rBx1 + self.rBx3 * gamma**2) * math.cos(math.atan(self.rBx2 * kappa)) * self.lambda_xalpha
        Exa = self.cap(self.rEx1 + self.rEx2 * df)
        weight = lambda a: math.cos(self.curve(Bxa, self.rCx1, Exa, a))
        Fx = weight(alpha + self.rHx1) / weight(self.rHx1) * Fxo
        # lateral force, pure slip
        leaning, upright = self.side(Fz, alpha, gamma, df, dp, n, tiny), self.side(Fz, alpha, 0, df, dp, n, tiny)

        # lateral force, combined slip
        def lateral_weight(g):
            Byk = (self.rBy1 + self.rBy4 * g**2) * math.cos(math.atan(self.rBy2 * (alpha - self.rBy3)))
            Eyk, SHyk = self.cap(self.rEy1 + self.rEy2 * df), self.rHy1 + self.rHy2 * df
            form = lambda k: math.cos(self.curve(Byk * self.lambda_ykappa, self.rCy1, Eyk, k))
            return form(kappa + SHyk) / form(SHyk)

        DVyk = (leaning["mu"] * Fz * (self.rVy1 + self.rVy2 * df + self.rVy3 * gamma)
                * math.cos(math.atan(self.rVy4 * alpha)))
        SVyk = DVyk * math.sin(self.rVy5 * math.atan(self.rVy6 * kappa)) * self.lambda_Vykappa
        Fy = lateral_weight(gamma) * leaning["F"] + SVyk
        Mz = self.aligning(Fz, kappa, alpha, gamma, df, dp, n, ca, direction, Kx, leaning,
                           lateral_weight(0) * upright["F"])
        Mz += (self.R0 * (self.ssz1 + self.ssz2 * Fy / n + (self.ssz3 + self.ssz4 * df) * gamma)
               * self.lambda_s * Fx)
        Mx = self.R0 * Fz * self.lambda_Mx * (
            self.qsx1 * self.lambda_VMx - self.qsx2 * gamma * (1 + self.ppMx1 * dp) + self.qsx3 * Fy / self.Fz0
            + self.qsx4 * math.cos(self.qsx5 * math.atan((self.qsx6 * Fz / self.Fz0)**2))
            * math.sin(self.qsx7 * gamma + self.qsx8 * math.atan(self.qsx9 * Fy / self.Fz0))
            + self.qsx10 * math.atan(self.qsx11 * Fz / self.Fz0) * gamma)
        My = -self.R0 * self.Fz0 * self.lambda_My * (
            self.qsy1 + self.qsy2 * Fx / self.Fz0 + self.qsy3 * V * direction / self.V0
            + self.qsy4 * (V / self.V0)**4 + (self.qsy5 + self.qsy6 * Fz / self.Fz0) * gamma**2)
        My *= (Fz / self.Fz0 + (1e-12 if self.smooth else 0))**self.qsy7 * (self.pressure / self.nominal_pressure)**self.qsy8 * direction
        return [Fx, Fy, Mx, My, Mz]

    def side(self, Fz, alpha, gamma, df, dp, n, tiny):
        Ky = (self.pKy1 * n * (1 + self.ppy1 * dp) * (1 - self.pKy3 * self.mag(gamma))
              * math.sin(self.pKy4 * math.atan(Fz / n / ((self.pKy2 + self.pKy5 * gamma**2)
                                                         * (1 + self.ppy2 * dp)))) * self.lambda_Kyalpha)
        amu = 10 * self.lambda_muy / (1 + 9 * self.lambda_muy)
        mu = ((self.pDy1 + self.pDy2 * df) * (1 + self.ppy3 * dp + self.ppy4 * dp**2)
              * (1 - self.pDy3 * gamma**2) * self.lambda_muy)
        SVyg = Fz * (self.pVy3 + self.pVy4 * df) * gamma * self.lambda_Kygamma * amu
        Kyg = Fz * (self.pKy6 + self.pKy7 * df) * (1 + self.ppy5 * dp) * self.lambda_Kygamma
        SHy = (self.pHy1 + self.pHy2 * df) * self.lambda_Hy + (Kyg * gamma - SVyg) / Ky
        SVy = Fz * (self.pVy1 + self.pVy2 * df) * self.lambda_Vy * amu + SVyg
        ay, Cy, Dy = alpha + SHy, self.pCy1 * self.lambda_Cy, mu * Fz
        Ey = self.cap((self.pEy1 + self.pEy2 * df)
                      * (1 + self.pEy5 * gamma**2 - (self.pEy3 + self.pEy4 * gamma) * self.sgn(ay)) * self.lambda_Ey)
        By = Ky / (Cy * Dy + tiny)
        F = Dy * math.sin(self.curve(By, Cy, Ey, ay)) + SVy
        return dict(F=F, K=Ky, SH=SHy, SV=SVy, mu=mu, BC=By * Cy)

    def aligning(self, Fz, kappa, alpha, gamma, df, dp, n, ca, direction, Kx, leaning, carried):
        at = alpha + self.qHz1 + self.qHz2 * df + (self.qHz3 + self.qHz4 * df) * gamma
        Bt = ((self.qBz1 + self.qBz2 * df + self.qBz3 * df**2)
              * (1 + self.qBz5 * self.mag(gamma) + self.qBz6 * gamma**2) * self.lambda_Kyalpha / self.lambda_muy)
        Ct = self.qCz1
        Dt = (Fz * self.R0 / n * (self.qDz1 + self.qDz2 * df) * (1 - self.ppz1 * dp) * self.lambda_t
              * (1 + self.qDz3 * self.mag(gamma) + self.qDz4 * gamma**2))
        Et = self.cap((self.qEz1 + self.qEz2 * df + self.qEz3 * df**2)
                      * (1 + (self.qEz4 + self.qEz5 * gamma) * 2 / math.pi * math.atan(Bt * Ct * at)))
        stretch, e = Kx / leaning["K"] * kappa, 1e-6 if self.smooth else 0
        t = Dt * math.cos(self.curve(Bt, Ct, Et, math.hypot(at, stretch, e))) * ca
        Dr = Fz * self.R0 * ((self.qDz6 + self.qDz7 * df) * self.lambda_Mr
                             + ((self.qDz8 + self.qDz9 * df) * (1 + self.ppz2 * dp)
                                + (self.qDz10 + self.qDz11 * df) * self.mag(gamma)) * gamma * self.lambda_Kzgamma)
        Dr *= ca * direction * self.lambda_muy
        Br = self.qBz9 * self.lambda_Kyalpha / self.lambda_muy + self.qBz10 * leaning["BC"]
        ar = alpha + leaning["SH"] + leaning["SV"] / leaning["K"]
        return -t * carried + Dr * math.cos(math.atan(Br * math.hypot(ar, stretch, e)))


def cases(c):
    source = random.Random(5)
    rows = []
    for i in range(40):
        Fz = source.uniform(800, 8000)
        kappa, alpha = source.uniform(-1, 1)**3, source.uniform(-1, 1)**3
        gamma = source.uniform(-0.3, 0.3) if i % 4 else 0.0
        V = source.uniform(1, 40)
        rounded = Tyre(c, True).at(Fz, kappa, alpha, gamma, V)
        sharp = Tyre(c, False).at(Fz, kappa, alpha, gamma, V)
        units = [Fz, Fz, Fz * c["R0"], Fz * c["R0"], Fz * c["R0"]]
        apart = max(abs(a - b) / u for a, b, u in zip(rounded, sharp, units))
        rows.append([Fz, kappa, alpha, gamma, V, *rounded, apart])
    return rows


def main():
    out = ["// Written by magic_formula_reference.py.", "#pragma once", "", "#include <cstddef>", "#include <utility>", "#include <vector>", "",
           "namespace magic_formula_reference {", "",
           "// All coefficients, in the order of magic_formula_coefficients, and rows of Fz, kappa, tan alpha, sin gamma,",
           "// V_x, F_x, F_y, M_x, M_y, M_z and the largest relative difference from the unrounded formula.",
           "struct tyre_reference {", "  std::vector<double> coefficients;",
           "  std::vector<std::vector<double>> cases;", "};", ""]
    for name, c in (("passenger_car", complete(CAR)), ("every_term", every_term())):
        out.append(f"inline const tyre_reference {name}{{")
        out.append("    {" + ", ".join(repr(float(c[n])) for n in NAMES) + "},")
        out.append("    {" + ",\n     ".join("{" + ", ".join(repr(v) for v in row) + "}" for row in cases(c)) + "}};")
        out.append("")
    asymmetries = [n for n in NAMES if n[:3] in ("pHx", "pHy", "pVx", "pVy", "rHx", "rHy", "qHz", "ssz", "rVy")
                   or n in ("rBy3", "qDz6", "qDz7", "pEy3", "qEz4", "pEx4")]
    out.append("// The places of the coefficients of asymmetries.")
    out.append("inline const std::vector<std::pair<std::size_t, const char*>> asymmetries{")
    out.append("    " + ", ".join(f"{{{NAMES.index(n)}, \"{n}\"}}" for n in asymmetries) + "};")
    out.append("")
    out.append("} // namespace magic_formula_reference")
    print("\n".join(out))


main()
