// Leg inverse kinematics against KDL's Levenberg-Marquardt in one process: the huntsman's eight legs, the same
// targets and the same tolerance. KDL's solver knows no joint limits; ours keeps them.

#include <fmt/format.h>

#include <ctime>
#include <deque>
#include <functional>
#include <kdl/chain.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <memory>
#include <string>
#include <vector>

#include "../species_legs.hpp"
#include "foot_paths.hpp"
#include "leg_lanes.hpp"

namespace {

using namespace orbweaver;
using namespace orbweaver::spider;

double thread_seconds() {
    timespec now{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// One leg in leg lengths, so that tolerances compare. Its solver points into it: it stays where it is.
class KdlLeg {
public:
    KdlLeg(const Leg& leg, double tolerance) : length_(leg.length), angles_(kJoints), found_(kJoints) {
        chain_.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::RotY)));
        chain_.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::RotX)));
        for (const double bone : leg.bone)
            chain_.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::RotZ), KDL::Frame(KDL::Vector(bone, 0, 0))));
        Eigen::Matrix<double, 6, 1> weights;
        weights << 1, 1, 1, 0, 0, 0;  // position alone
        solver_ = std::make_unique<KDL::ChainIkSolverPos_LMA>(chain_, weights, tolerance);
        set_pose(rest_pose(leg));
    }

    void set_pose(const LegPose& pose) {
        for (std::size_t j = 0; j < kJoints; ++j) angles_(static_cast<unsigned>(j)) = pose[j];
    }

    /// How far the foot ends from the target, leg lengths.
    double solve(const Vec3& target) {
        const KDL::Vector at(target.x / length_, target.y / length_, target.z / length_);
        solver_->CartToJnt(angles_, KDL::Frame(at), found_);
        angles_ = found_;
        return solver_->lastTransDiff;
    }

private:
    double length_;
    KDL::Chain chain_;
    KDL::JntArray angles_, found_;
    std::unique_ptr<KDL::ChainIkSolverPos_LMA> solver_;
};

struct Contender {
    std::string name;
    std::function<int(bool cold, std::size_t t)>
        solve;                  ///< all legs; how many ended within 1e-4 of their length
    double nanoseconds = 1e12;  ///< of one leg
    int reached = 0;
};

/// The best of many rounds, in which contenders take turns: what else runs on the machine hits all of them.
void race(const std::string& title, bool cold, std::size_t legs, std::vector<Contender>& all) {
    const double solved = static_cast<double>(legs * FootPaths::kTimes);
    for (Contender& each : all) each.nanoseconds = 1e12;
    for (int round = 0; round < 25; ++round)
        for (Contender& each : all) {
            each.reached = 0;
            const double start = thread_seconds();
            for (std::size_t t = 0; t < FootPaths::kTimes; ++t) each.reached += each.solve(cold, t);
            each.nanoseconds = std::min(each.nanoseconds, 1e9 * (thread_seconds() - start) / solved);
        }
    fmt::print("\n{}\n", title);
    for (const Contender& each : all)
        fmt::print("  {:<24} {:9.1f} ns a leg   {:8.3f} % reached   {:7.1f} times as fast as KDL\n", each.name,
                   each.nanoseconds, 100 * each.reached / solved, all.front().nanoseconds / each.nanoseconds);
}

bool near(double error, const Leg& leg) { return error <= 1e-4 * leg.length; }

std::vector<Contender> contenders(const FootPaths& paths, double tolerance) {
    const auto kdl = std::make_shared<std::deque<KdlLeg>>();
    for (const Leg& leg : paths.legs()) kdl->emplace_back(leg, tolerance);
    std::vector<Contender> all;
    all.push_back({"KDL, no limits", [&paths, kdl](bool cold, std::size_t t) {
                       int reached = 0;
                       for (std::size_t i = 0; i < paths.legs().size(); ++i) {
                           KdlLeg& leg = (*kdl)[i];
                           if (cold) leg.set_pose(rest_pose(paths.legs()[i]));
                           const LegTarget& target = paths.at(cold, i, t);
                           reached += leg.solve(target.position) <= 1e-4;
                       }
                       return reached;
                   }});
    LegSolverOptions options;
    options.tolerance = tolerance;
    const auto poses = std::make_shared<std::vector<LegPose>>();
    for (const Leg& leg : paths.legs()) poses->push_back(rest_pose(leg));
    all.push_back({"half Jacobian", [&paths, options, poses](bool cold, std::size_t t) {
                       static const LegSolver& solver = *find_leg_solver("half_jacobian");
                       int reached = 0;
                       for (std::size_t i = 0; i < paths.legs().size(); ++i) {
                           const Leg& leg = paths.legs()[i];
                           if (cold) (*poses)[i] = rest_pose(leg);
                           const LegTarget& target = paths.at(cold, i, t);
                           reached += near(solver.solve(leg, target, options, (*poses)[i]).error, leg);
                       }
                       return reached;
                   }});
    for (const LaneKernel& kernel : lane_kernels()) {
        const auto lanes = std::make_shared<LegLanes>(paths.legs(), kernel);
        const auto angles = std::make_shared<std::vector<double>>(lanes->angle_count());
        for (std::size_t i = 0; i < lanes->size(); ++i) lanes->set_pose(*angles, i, rest_pose(lanes->leg(i)));
        const auto targets = std::make_shared<std::vector<double>>(lanes->target_count());
        const auto results = std::make_shared<std::vector<LegResult>>(lanes->size());
        all.push_back({std::string("in lanes, ") + kernel.name,
                       [&paths, options, lanes, angles, targets, results](bool cold, std::size_t t) {
                           for (std::size_t i = 0; i < lanes->size(); ++i) {
                               if (cold) lanes->set_pose(*angles, i, rest_pose(lanes->leg(i)));
                               lanes->set_target(*targets, i, paths.at(cold, i, t).position);
                           }
                           lanes->solve(*targets, options, *angles, *results);
                           int reached = 0;
                           for (std::size_t i = 0; i < lanes->size(); ++i)
                               reached += near((*results)[i].error, lanes->leg(i));
                           return reached;
                       }});
    }
    return all;
}

}  // namespace

int main() {
    for (const double tolerance : {1e-6, 1e-4})
        for (const double step : {0.002, 0.01, 0.05}) {
            const FootPaths paths(spider::test::species_legs("huntsman"), step);
            auto all = contenders(paths, tolerance);
            race(fmt::format("warm, feet move by {} of the leg's length a call, tolerance {}", step, tolerance),
                 false, paths.legs().size(), all);
            if (step == 0.05)
                race(fmt::format("cold, from the rest pose, tolerance {}", tolerance), true,
                     paths.legs().size(), all);
        }
}
