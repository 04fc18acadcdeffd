/* Uses the emitted sources: answers a line for each line of points. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "determinant.h"
#include "match.h"
#include "quadratic_form.h"
#include "rod.h"

static double number(uint64_t bits)
{
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static void answer(double plain, double batch, sextic_bounded bounded, const char *after)
{
    uint64_t bits[4];
    memcpy(&bits[0], &bounded.value, sizeof bits[0]);
    memcpy(&bits[1], &bounded.error, sizeof bits[1]);
    memcpy(&bits[2], &plain, sizeof bits[2]);
    memcpy(&bits[3], &batch, sizeof bits[3]);
    /* The scalar, the batch and the value with a bound are one, whatever a NaN looks like. */
    if ((bits[0] != bits[2] || bits[0] != bits[3]) && (plain == plain || batch == batch)) {
        fprintf(stderr, "%a %a %a differ\n", plain, batch, bounded.value);
        exit(1);
    }
    printf("%" PRIx64 " %" PRIx64 "%s", bits[0], bits[1], after);
}

int main(void)
{
    char name[32];
    while (scanf("%31s", name) == 1) {
        const int count = strcmp(name, "determinant") == 0 ? 9
                          : strcmp(name, "match") == 0     ? 6
                          : strcmp(name, "rod") == 0       ? 4
                          : strcmp(name, "angles") == 0    ? 3
                                                           : 5;
        double v[9], r[5];
        for (int place = 0; place < count; place++) {
            uint64_t bits;
            if (scanf("%" SCNx64, &bits) != 1) {
                return 1;
            }
            v[place] = number(bits);
        }
        if (count == 9) {
            const determinant_inputs in = {v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8]};
            const determinant_slices many = {&v[0], &v[1], &v[2], &v[3], &v[4], &v[5], &v[6], &v[7], &v[8]};
            const determinant_slices_mut out = {&r[0], &r[1]};
            const determinant_outputs plain = determinant(&in);
            const determinant_bounds bounds = determinant_with_bound(&in);
            determinant_batch(1, &many, &out);
            answer(plain.quotient, r[0], bounds.quotient, " ");
            answer(plain.trace, r[1], bounds.trace, "\n");
        } else if (count == 6) {
            const match_inputs in = {v[0], v[1], v[2], v[3], v[4], v[5]};
            const match_slices many = {&v[0], &v[1], &v[2], &v[3], &v[4], &v[5]};
            const match_slices_mut out = {&r[0], &r[1], &r[2], &r[3], &r[4]};
            const match_outputs plain = match(&in);
            const match_bounds bounds = match_with_bound(&in);
            match_batch(1, &many, &out);
            answer(plain.I_, r[0], bounds.I_, " ");
            answer(plain.nested, r[1], bounds.nested, " ");
            answer(plain.again, r[2], bounds.again, " ");
            answer(plain.same, r[3], bounds.same, " ");
            answer(plain.three, r[4], bounds.three, "\n");
        } else if (count == 4) {
            const rod_inputs in = {v[0], v[1], v[2], v[3]};
            const rod_slices many = {&v[0], &v[1], &v[2], &v[3]};
            const rod_slices_mut out = {&r[0], &r[1], &r[2], &r[3]};
            const rod_outputs plain = rod(&in);
            const rod_bounds bounds = rod_with_bound(&in);
            rod_batch(1, &many, &out);
            answer(plain.reach, r[0], bounds.reach, " ");
            answer(plain.height, r[1], bounds.height, " ");
            answer(plain.scale, r[2], bounds.scale, " ");
            answer(plain.ratio, r[3], bounds.ratio, "\n");
        } else if (count == 3) {
            const rod_angles angles = {.L = v[0], .theta_0 = v[1], .beta = v[2]};
            const rod_inputs in = rod_inputs_at(&angles);
            const double found[4] = {
                in.L,
                in.cos_alpha_g_plus_theta_0,
                in.sin_alpha_g_plus_theta_0,
                in.cos_2_beta_minus_theta_0,
            };
            for (int place = 0; place < 4; place++) {
                uint64_t bits;
                memcpy(&bits, &found[place], sizeof bits);
                printf("%" PRIx64 "%s", bits, place < 3 ? " " : "\n");
            }
        } else {
            const quadratic_form_inputs in = {v[0], v[1], v[2], v[3], v[4]};
            const quadratic_form_slices many = {&v[0], &v[1], &v[2], &v[3], &v[4]};
            const quadratic_form_slices_mut out = {&r[0], &r[1]};
            const quadratic_form_outputs plain = quadratic_form(&in);
            const quadratic_form_bounds bounds = quadratic_form_with_bound(&in);
            quadratic_form_batch(1, &many, &out);
            answer(plain.value, r[0], bounds.value, " ");
            answer(plain.slope, r[1], bounds.slope, "\n");
        }
    }
    return 0;
}
