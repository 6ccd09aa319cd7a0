/* Kernels on arrays of points, `LANES` at a time. Compiled after lanes.h and the kernels themselves. */

typedef int (*Evaluate)(const Lanes** arg, Lanes** res, casadi_int* iw, Lanes* w, int mem);
typedef int (*WorkSize)(casadi_int* arg, casadi_int* res, casadi_int* iw, casadi_int* w);

/* A kernel as the library shows it. */
struct Kernel {
    Evaluate evaluate;
    WorkSize work_size;
};

#define KERNEL(name) \
    extern "C" { extern const Kernel lockstep_##name; const Kernel lockstep_##name = {name, name##_work}; }

namespace {

Lanes* new_lanes(casadi_int n) { return (Lanes*) aligned_alloc(sizeof(Lanes), (size_t) (n + 1) * sizeof(Lanes)); }

/* A kernel with its work space, its inputs and its outputs. */
class Call {
public:
    Call(const Kernel* kernel, casadi_int n_in, const casadi_int* in_size, casadi_int n_out, const casadi_int* out_size)
        : kernel(kernel), n_in(n_in), n_out(n_out)
    {
        casadi_int n_arg, n_res, n_iw, n_w;
        kernel->work_size(&n_arg, &n_res, &n_iw, &n_w);
        arg = (const Lanes**) malloc((size_t) n_arg * sizeof(Lanes*));
        res = (Lanes**) malloc((size_t) n_res * sizeof(Lanes*));
        iw = (casadi_int*) malloc((size_t) (n_iw + 1) * sizeof(casadi_int));
        w = new_lanes(n_w);
        data = new_lanes(total(n_in, in_size) + total(n_out, out_size));
        in = (Lanes**) malloc((size_t) n_in * sizeof(Lanes*));
        out = (Lanes**) malloc((size_t) n_out * sizeof(Lanes*));
        ready = arg && res && iw && w && data && in && out;
        if (!ready) return;
        Lanes* next = data;
        for (casadi_int j = 0; j < n_in; next += in_size[j++]) in[j] = next;
        for (casadi_int j = 0; j < n_out; next += out_size[j++]) out[j] = next;
    }

    ~Call()
    {
        free(arg); free(res); free(iw); free(w); free(data); free(in); free(out);
    }

    /* Kernels use the rest of `arg` and `res` for calls of their own. */
    int operator()()
    {
        for (casadi_int j = 0; j < n_in; j++) arg[j] = in[j];
        for (casadi_int j = 0; j < n_out; j++) res[j] = out[j];
        return kernel->evaluate(arg, res, iw, w, 0);
    }

    bool ready;
    Lanes **in, **out;

private:
    Call(const Call&);
    Call& operator=(const Call&);

    static casadi_int total(casadi_int n, const casadi_int* size)
    {
        casadi_int sum = 0;
        for (casadi_int j = 0; j < n; j++) sum += size[j];
        return sum;
    }

    const Kernel* kernel;
    casadi_int n_in, n_out;
    const Lanes** arg;
    Lanes** res;
    casadi_int* iw;
    Lanes *w, *data;
};

void put(const double* from, casadi_int size, Lanes* to, int lane)
{
    for (casadi_int k = 0; k < size; k++) to[k].v[lane] = from[k];
}

void get(const Lanes* from, int lane, casadi_int size, double* to)
{
    for (casadi_int k = 0; k < size; k++) to[k] = from[k].v[lane];
}

/* Largest modulus in terms of scales; NaN if there is one. */
double norm(const double* x, const double* scale, casadi_int n)
{
    double largest = 0;
    for (casadi_int k = 0; k < n; k++) {
        const double size = fabs(x[k] / scale[k]);
        if (!(size <= largest)) largest = size;
        if (size != size) break;
    }
    return largest;
}

/* Triangular factors of a matrix in its place, with row interchanges; it is stored by columns. */
void factorise(double* a, casadi_int* pivot, casadi_int n)
{
    for (casadi_int c = 0; c < n; c++) {
        casadi_int largest = c;
        for (casadi_int r = c + 1; r < n; r++)
            if (fabs(a[r + c * n]) > fabs(a[largest + c * n])) largest = r;
        pivot[c] = largest;
        for (casadi_int k = 0; k < n; k++) {
            const double t = a[c + k * n];
            a[c + k * n] = a[largest + k * n];
            a[largest + k * n] = t;
        }
        for (casadi_int r = c + 1; r < n; r++) {
            const double factor = a[r + c * n] /= a[c + c * n];
            for (casadi_int k = c + 1; k < n; k++) a[r + k * n] -= factor * a[c + k * n];
        }
    }
}

/* The solution for a right-hand side, in its place. */
void solve_factorised(const double* a, const casadi_int* pivot, double* b, casadi_int n)
{
    for (casadi_int c = 0; c < n; c++) {
        const double t = b[c];
        b[c] = b[pivot[c]];
        b[pivot[c]] = t;
    }
    for (casadi_int c = 0; c < n; c++)
        for (casadi_int r = c + 1; r < n; r++) b[r] -= a[r + c * n] * b[c];
    for (casadi_int r = n - 1; r >= 0; r--) {
        for (casadi_int k = r + 1; k < n; k++) b[r] -= a[r + k * n] * b[k];
        b[r] /= a[r + r * n];
    }
}

} /* namespace */

/* Map kernels of the same inputs and outputs over points: the first over count[0] points, and so on.
 * The points are those that `points` names, one kernel's after the other's; all in their order if it is NULL.
 * Point i reads in[j] + i*in_size[j] and writes out[j] + i*out_size[j].
 * Returns 0, or 1 when there is no memory, or 2 when a kernel failed. */
extern "C" int lockstep_map(casadi_int n_kernels, const Kernel* const* kernels, const casadi_int* count,
    const casadi_int* points, casadi_int n_in, const double* const* in, const casadi_int* in_size,
    casadi_int n_out, double* const* out, const casadi_int* out_size)
{
    casadi_int done = 0, point[LANES];
    for (casadi_int one = 0; one < n_kernels; done += count[one++]) {
        Call call(kernels[one], n_in, in_size, n_out, out_size);
        if (!call.ready) return 1;
        for (casadi_int i = 0; i < count[one]; i += LANES) {
            const int used = count[one] - i < LANES ? (int) (count[one] - i) : LANES;
            for (int lane = 0; lane < LANES; lane++) {
                const casadi_int row = done + i + (lane < used ? lane : used - 1); /* others repeat the last */
                point[lane] = points ? points[row] : row;
                for (casadi_int j = 0; j < n_in; j++)
                    put(in[j] + point[lane] * in_size[j], in_size[j], call.in[j], lane);
            }
            if (call()) return 2;
            for (casadi_int j = 0; j < n_out; j++)
                for (casadi_int k = 0; k < out_size[j]; k++)
                    for (int lane = 0; lane < used; lane++)
                        out[j][point[lane] * out_size[j] + k] = call.out[j][k].v[lane];
        }
    }
    return 0;
}

/* Newton's method for n points, as CasADi's fast_newton: it stops at a residual of `abstol`, after a step of
 * `abstol_step`, or after `iterations`. A lane that is done takes the next point.
 * The first is in terms of the scales in `rows`, the second of those in `unknowns`; nu each.
 *
 * jacobian: (u, p) -> (J, R). residual: (u, p) -> R in the place of the second output, or NULL.
 * u: guesses, shape (n, nu), replaced by the solutions. Returns as lockstep_map. */
extern "C" int lockstep_newton(const Kernel* jacobian, const Kernel* residual, casadi_int n, casadi_int nu,
    casadi_int np, double* u, const double* p, const double* unknowns, const double* rows, double abstol,
    double abstol_step, int iterations)
{
    const casadi_int in_size[] = {nu, np}, out_size[] = {nu * nu, nu};
    Call derivative(jacobian, 2, in_size, 2, out_size);
    Call value(residual ? residual : jacobian, 2, in_size, residual ? 1 : 2, residual ? out_size + 1 : out_size);
    double* const work = (double*) malloc((size_t) (nu * nu + nu) * sizeof(double));
    double *const a = work, *const r = work + nu * nu;
    casadi_int* const pivot = (casadi_int*) malloc((size_t) nu * sizeof(casadi_int));
    casadi_int point[LANES], next = 0;
    int turn[LANES], status = derivative.ready && value.ready && work && pivot ? 0 : 1;

    if (status) n = 0;
    for (int lane = 0; lane < LANES && n > 0; lane++) {
        point[lane] = next < n ? next++ : -1;
        turn[lane] = 0;
        const casadi_int start = point[lane] < 0 ? 0 : point[lane];
        put(u + start * nu, nu, derivative.in[0], lane);
        put(p + start * np, np, derivative.in[1], lane);
    }
    for (casadi_int open = n; open > 0 && !status;) {
        status = derivative() ? 2 : 0;
        if (residual) {
            for (casadi_int k = 0; k < nu; k++) value.in[0][k] = derivative.in[0][k];
            for (casadi_int k = 0; k < np; k++) value.in[1][k] = derivative.in[1][k];
            status |= value() ? 2 : 0;
        }
        const Lanes* const closing = residual ? value.out[0] : derivative.out[1];
        for (int lane = 0; lane < LANES; lane++) {
            if (point[lane] < 0) continue;
            double* const mine = u + point[lane] * nu;
            get(closing, lane, nu, r);
            int done = !(norm(r, rows, nu) > abstol);
            if (!done) {
                get(derivative.out[0], lane, nu * nu, a);
                factorise(a, pivot, nu);
                solve_factorised(a, pivot, r, nu);
                for (casadi_int k = 0; k < nu; k++) mine[k] -= r[k];
                done = !(norm(r, unknowns, nu) > abstol_step) || ++turn[lane] == iterations;
            }
            if (done) {
                open--;
                turn[lane] = 0;
                point[lane] = next < n ? next++ : -1;
                if (point[lane] >= 0) put(p + point[lane] * np, np, derivative.in[1], lane);
            }
            if (point[lane] >= 0) put(u + point[lane] * nu, nu, derivative.in[0], lane);
        }
    }
    free(work);
    free(pivot);
    return status;
}
