/* Residuals in numbers of twice the digits, at arrays of points. Compiled after pairs.h and the kernels. */

typedef int (*Evaluate)(const Pair** arg, Pair** res, casadi_int* iw, Pair* w, int mem);
typedef int (*WorkSize)(casadi_int* arg, casadi_int* res, casadi_int* iw, casadi_int* w);

/* A kernel as the library shows it. */
struct Kernel {
    Evaluate evaluate;
    WorkSize work_size;
};

#define KERNEL(name) \
    extern "C" { extern const Kernel precise_##name; const Kernel precise_##name = {name, name##_work}; }

namespace {

/* Memory for n numbers. */
Pair* new_array(casadi_int n) { return (Pair*) aligned_alloc(sizeof(Vector), (size_t) (n + 1) * sizeof(Pair)); }

/* What a kernel needs. */
struct Work {
    const Pair** arg;
    Pair** res;
    casadi_int* iw;
    Pair* w;
    const Kernel* kernel;

    explicit Work(const Kernel* kernel) : kernel(kernel)
    {
        casadi_int n_arg, n_res, n_iw, n_w;
        kernel->work_size(&n_arg, &n_res, &n_iw, &n_w);
        arg = (const Pair**) malloc((size_t) n_arg * sizeof(Pair*));
        res = (Pair**) malloc((size_t) n_res * sizeof(Pair*));
        iw = (casadi_int*) malloc((size_t) (n_iw + 1) * sizeof(casadi_int));
        w = new_array(n_w);
    }
    ~Work() { free(arg); free(res); free(iw); free(w); }
    bool ready() const { return arg && res && iw && w; }
    int run() const { return kernel->evaluate(arg, res, iw, w, 0) ? 2 : 0; }
};

/* Section points with periods and parameters of the points i to i + LANES; the last lanes repeat the last point. */
void take(casadi_int n, casadi_int i, casadi_int nu, casadi_int np, const double* u, const double* p, Pair* point)
{
    for (casadi_int k = 0; k < nu + np; k++) {
        point[k] = Pair(0.0);
        for (int lane = 0; lane < LANES; lane++) {
            const casadi_int at = i + lane < n ? i + lane : n - 1;
            point[k].hi[lane] = k < nu ? u[at * nu + k] : p[at * np + k - nu];
        }
    }
}

/* Their residuals as doubles. */
void put(casadi_int n, casadi_int i, casadi_int nu, const Pair* residual, double* out)
{
    for (casadi_int k = 0; k < nu; k++)
        for (int lane = 0; lane < LANES && i + lane < n; lane++) out[(i + lane) * nu + k] = rounded(residual[k])[lane];
}

} /* namespace */

/* A residual (u, p) -> R at n points. u, out: shape (n, nu). p: shape (n, np).
 * Returns 0, or 1 when there is no memory, or 2 when the kernel failed. */
extern "C" int precise_map(const Kernel* kernel, casadi_int n, casadi_int nu, casadi_int np, const double* u,
    const double* p, double* out)
{
    const Work whole(kernel);
    Pair* const point = new_array(2 * nu + np);
    int status = whole.ready() && point ? 0 : 1;
    for (casadi_int i = 0; i < n && !status; i += LANES) {
        take(n, i, nu, np, u, p, point);
        whole.arg[0] = point;
        whole.arg[1] = point + nu;
        whole.res[0] = point + nu + np;
        status = whole.run();
        put(n, i, nu, point + nu + np, out);
    }
    free(point);
    return status;
}

/* The same on any number of blocks of RK steps, chained from the kernels of its pieces: begin (u, p) -> y, with ny
 * numbers; swing (t, h, y, p) -> y, one block of RK steps of size h; end (y, u, p) -> R. */
extern "C" int precise_chain(const Kernel* begin, const Kernel* swing, const Kernel* end, casadi_int n_blocks,
    casadi_int block, casadi_int n, casadi_int nu, casadi_int np, casadi_int ny, const double* u, const double* p,
    double* out)
{
    const Work first(begin), each(swing), last(end);
    Pair *const point = new_array(2 * nu + np + 2 + 2 * ny), *const params = point + nu, *const t = params + np,
                *const h = t + 1, *const residual = h + 1, *y = residual + nu, *next = y + ny;
    int status = first.ready() && each.ready() && last.ready() && point ? 0 : 1;
    for (casadi_int i = 0; i < n && !status; i += LANES) {
        take(n, i, nu, np, u, p, point);
        *h = point[nu - 1] / Pair((double) (n_blocks * block));
        first.arg[0] = point;
        first.arg[1] = params;
        first.res[0] = y;
        status = first.run();
        for (casadi_int k = 0; k < n_blocks && !status; k++) {
            *t = *h * Pair((double) (k * block));
            each.arg[0] = t;
            each.arg[1] = h;
            each.arg[2] = y;
            each.arg[3] = params;
            each.res[0] = next;
            status = each.run();
            Pair* const done = next;
            next = y;
            y = done;
        }
        last.arg[0] = y;
        last.arg[1] = point;
        last.arg[2] = params;
        last.res[0] = residual;
        if (!status) status = last.run();
        put(n, i, nu, residual, out);
    }
    free(point);
    return status;
}
