#include "wide_vector.hpp"

#include <nvector/nvector_serial.h>

#include <algorithm>
#include <cmath>

namespace orbweaver::peers {
namespace {

double* data(N_Vector v) { return NV_DATA_S(v); }
sunindextype size(N_Vector v) { return NV_LENGTH_S(v); }

/// body(i) of every element; elements do not depend on each other, operands may be the same vector.
template <class Body>
void each(N_Vector v, const Body& body) {
    const sunindextype n = size(v);
#pragma omp simd
    for (sunindextype i = 0; i < n; ++i) body(i);
}

template <class Term>
double sum(N_Vector v, const Term& term) {
    const sunindextype n = size(v);
    double total = 0;
#pragma omp simd reduction(+ : total)
    for (sunindextype i = 0; i < n; ++i) total += term(i);
    return total;
}

void linear_sum(double a, N_Vector x, double b, N_Vector y, N_Vector z) {
    each(z, [a, b, x = data(x), y = data(y), z = data(z)](sunindextype i) { z[i] = a * x[i] + b * y[i]; });
}
void constant(double c, N_Vector z) { std::fill_n(data(z), size(z), c); }
void product(N_Vector x, N_Vector y, N_Vector z) {
    each(z, [x = data(x), y = data(y), z = data(z)](sunindextype i) { z[i] = x[i] * y[i]; });
}
void quotient(N_Vector x, N_Vector y, N_Vector z) {
    each(z, [x = data(x), y = data(y), z = data(z)](sunindextype i) { z[i] = x[i] / y[i]; });
}
void scale(double c, N_Vector x, N_Vector z) {
    each(z, [c, x = data(x), z = data(z)](sunindextype i) { z[i] = c * x[i]; });
}
void absolute(N_Vector x, N_Vector z) {
    each(z, [x = data(x), z = data(z)](sunindextype i) { z[i] = std::fabs(x[i]); });
}
void inverse(N_Vector x, N_Vector z) {
    each(z, [x = data(x), z = data(z)](sunindextype i) { z[i] = 1 / x[i]; });
}
void add_constant(N_Vector x, double b, N_Vector z) {
    each(z, [b, x = data(x), z = data(z)](sunindextype i) { z[i] = x[i] + b; });
}
double dot_product(N_Vector x, N_Vector y) {
    return sum(x, [x = data(x), y = data(y)](sunindextype i) { return x[i] * y[i]; });
}
double weighted_norm(N_Vector x, N_Vector w) {
    const double squares = sum(x, [x = data(x), w = data(w)](sunindextype i) {
        const double each = x[i] * w[i];
        return each * each;
    });
    return std::sqrt(squares / static_cast<double>(size(x)));
}
double max_norm(N_Vector v) {
    const sunindextype n = size(v);
    const double* x = data(v);
    double largest = 0;
#pragma omp simd reduction(max : largest)
    for (sunindextype i = 0; i < n; ++i) largest = std::max(largest, std::fabs(x[i]));
    return largest;
}

/// z = sum of c_j X_j; X_0 may be z.
int linear_combination(int count, double* c, N_Vector* X, N_Vector z) {
    if (count == 1) return scale(c[0], X[0], z), 0;
    linear_sum(c[0], X[0], c[1], X[1], z);
    int j = 2;
    for (; j + 1 < count; j += 2)
        each(z, [a = c[j], b = c[j + 1], x = data(X[j]), y = data(X[j + 1]), z = data(z)](sunindextype i) {
            z[i] += a * x[i] + b * y[i];
        });
    if (j < count) each(z, [a = c[j], x = data(X[j]), z = data(z)](sunindextype i) { z[i] += a * x[i]; });
    return 0;
}

/// Z_j = a_j x + Y_j; Z_j may be Y_j.
int scale_add(int count, double* a, N_Vector x, N_Vector* Y, N_Vector* Z) {
    for (int j = 0; j < count; ++j) linear_sum(a[j], x, 1, Y[j], Z[j]);
    return 0;
}

}  // namespace

N_Vector make_wide_vector(sunindextype length, SUNContext context) {
    N_Vector v = N_VNew_Serial(length, context);
    v->ops->nvlinearsum = linear_sum;
    v->ops->nvconst = constant;
    v->ops->nvprod = product;
    v->ops->nvdiv = quotient;
    v->ops->nvscale = scale;
    v->ops->nvabs = absolute;
    v->ops->nvinv = inverse;
    v->ops->nvaddconst = add_constant;
    v->ops->nvdotprod = dot_product;
    v->ops->nvwrmsnorm = weighted_norm;
    v->ops->nvmaxnorm = max_norm;
    v->ops->nvlinearcombination = linear_combination;
    v->ops->nvscaleaddmulti = scale_add;
    return v;
}

}  // namespace orbweaver::peers
