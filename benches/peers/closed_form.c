/* Eqs. (21)-(23) of He & Macdonald (2017), as one writes them by hand: common parts have names, the rest
   is left to the compiler. The benchmark `evaluators` builds this with gcc -O3 -march=native. */

#include <stddef.h>

void closed_form(size_t points, const double *restrict m, const double *restrict r,
                 const double *restrict L_g, const double *restrict cosine, const double *restrict sine,
                 const double *restrict rho, const double *restrict D, const double *restrict U,
                 const double *restrict S_xx, const double *restrict S_xy, const double *restrict S_yx,
                 const double *restrict S_yy, const double *restrict S_xt, const double *restrict S_yt,
                 const double *restrict S_tx, const double *restrict S_ty, const double *restrict S_tt,
                 double *restrict lambda_1, double *restrict lambda_2, double *restrict lambda_3)
{
    for (size_t i = 0; i < points; i++) {
        const double c = cosine[i], s = sine[i];
        const double d_1 = -(S_xx[i] * s * s + S_yy[i] * c * c + (S_xy[i] + S_yx[i]) * s * c + S_tt[i]);
        const double d_2 = (S_ty[i] + S_yt[i]) * c + (S_xt[i] + S_tx[i]) * s;
        const double wind = rho[i] * D[i] * U[i];
        lambda_1[i] = wind / (8 * m[i]) * (r[i] / (r[i] - L_g[i])) * (d_1 + d_2);
        lambda_2[i] = -wind / (4 * m[i]) * (S_xx[i] + S_yy[i] + S_tt[i] + d_1);
        lambda_3[i] = wind / (8 * m[i]) * (r[i] / (r[i] + L_g[i])) * (d_1 - d_2);
    }
}
