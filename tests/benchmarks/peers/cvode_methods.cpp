// CVODE of SUNDIALS (BSD-3-Clause): Adams by fixed-point iteration, BDF by Newton's method with
// unpreconditioned GMRES, as its documents advise for problems that are not stiff and those that are.

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_spgmr.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <memory>
#include <stdexcept>

#include "contender.hpp"
#include "right_side.hpp"
#include "stopwatch.hpp"
#include "wide_vector.hpp"

namespace orbweaver::peers {
namespace {

using MakeVector = N_Vector (*)(sunindextype length, SUNContext context);

template <class T, void (*kFree)(T)>
struct Free {
    using pointer = T;
    void operator()(T it) const { kFree(it); }
};
void free_context(SUNContext context) { SUNContext_Free(&context); }
void free_cvode(void* cvode) { CVodeFree(&cvode); }
void free_nonlinear(SUNNonlinearSolver solver) { SUNNonlinSolFree(solver); }
void free_linear(SUNLinearSolver solver) { SUNLinSolFree(solver); }

int evaluate(double, N_Vector y, N_Vector rate, void* right_side) {
    static_cast<RightSide*>(right_side)->evaluate(NV_DATA_S(y), NV_DATA_S(rate));
    return 0;
}

void expect(int flag, const char* call) {
    if (flag < 0) throw std::runtime_error(std::string(call) + " of SUNDIALS returned " + std::to_string(flag));
}

/// All that one run needs; freed in the opposite order.
class Cvode {
public:
    Cvode(const Problem& problem, MakeRightSide make, MakeVector make_vector, int family, double tolerance)
        : right_side_(make(problem)) {
        SUNContext context = nullptr;
        expect(SUNContext_Create(nullptr, &context), "SUNContext_Create");
        context_.reset(context);
        y_.reset(make_vector(static_cast<sunindextype>(right_side_->length()), context));
        right_side_->pack(problem, NV_DATA_S(y_.get()));
        cvode_.reset(CVodeCreate(family, context));
        expect(CVodeInit(cvode_.get(), evaluate, 0, y_.get()), "CVodeInit");
        expect(CVodeSetUserData(cvode_.get(), right_side_.get()), "CVodeSetUserData");
        expect(CVodeSStolerances(cvode_.get(), tolerance, tolerance), "CVodeSStolerances");
        expect(CVodeSetMaxNumSteps(cvode_.get(), kMostSteps), "CVodeSetMaxNumSteps");
        expect(CVodeSetStopTime(cvode_.get(), problem.duration), "CVodeSetStopTime");
        family == CV_ADAMS ? iterate_fixed_point() : iterate_newton();
    }

    Run run(double duration) {
        double reached = 0;
        const Stopwatch watch;
        const int flag = CVode(cvode_.get(), duration, y_.get(), &reached, CV_NORMAL);
        Run run{{}, watch.seconds()};
        if (flag >= 0) run.x = right_side_->positions(NV_DATA_S(y_.get()));
        return run;
    }

private:
    static constexpr long kMostSteps = 10'000'000;

    void iterate_fixed_point() {
        nonlinear_.reset(SUNNonlinSol_FixedPoint(y_.get(), 0, context_.get()));
        expect(CVodeSetNonlinearSolver(cvode_.get(), nonlinear_.get()), "CVodeSetNonlinearSolver");
    }
    void iterate_newton() {
        linear_.reset(SUNLinSol_SPGMR(y_.get(), SUN_PREC_NONE, 0, context_.get()));
        expect(CVodeSetLinearSolver(cvode_.get(), linear_.get(), nullptr), "CVodeSetLinearSolver");
    }

    std::unique_ptr<RightSide> right_side_;
    std::unique_ptr<void, Free<SUNContext, free_context>> context_;
    std::unique_ptr<void, Free<N_Vector, N_VDestroy>> y_;
    std::unique_ptr<void, Free<SUNNonlinearSolver, free_nonlinear>> nonlinear_;
    std::unique_ptr<void, Free<SUNLinearSolver, free_linear>> linear_;
    std::unique_ptr<void, Free<void*, free_cvode>> cvode_;
};

}  // namespace

Contenders cvode_methods(const Problem& problem) {
    constexpr double kRatio = 0.1;  // its runs are long, and hardly longer within a tolerance ten times tighter
    struct Family {
        const char* name;
        int kind;
    };
    struct Vector {
        const char* name;
        MakeVector make;
    };
    Contenders all;
    for (const Family& family : {Family{"CVODE Adams", CV_ADAMS}, Family{"CVODE BDF, SPGMR", CV_BDF}})
        for (const Vector& vector : {Vector{"stock", N_VNew_Serial}, Vector{"wide", make_wide_vector}})
            for (const MakeRightSide make : kRightSides)
                all.push_back(
                    {std::string(family.name) + ", " + vector.name + " vectors",
                     std::string(make(problem)->name()), "tolerance", 1e-4, kRatio,
                     [&problem, kind = family.kind, make_vector = vector.make, make](double tolerance) {
                         return Cvode(problem, make, make_vector, kind, tolerance).run(problem.duration);
                     }});
    return all;
}

}  // namespace orbweaver::peers
