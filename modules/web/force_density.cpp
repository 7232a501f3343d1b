#include <Eigen/SparseCholesky>
#include <limits>

#include "orbweaver/fault.hpp"
#include "prestress.hpp"

namespace orbweaver::web {

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
constexpr int kFixed = -1;

/// The row of each particle in the system of equations; kFixed for anchors.
struct Rows {
    std::vector<int> of;
    int count = 0;
};

Rows number_free_particles(const Layout& layout) {
    Rows rows;
    for (const std::uint8_t fixed : layout.fixed) rows.of.push_back(fixed != 0 ? kFixed : rows.count++);
    return rows;
}

/// One end of a piece in the equations of its free end: q on the diagonal, and the other end either as an
/// unknown or, fixed, on the right-hand side.
class Equations {
public:
    Equations(const Layout& layout, const Rows& rows, std::span<const Vec3> loads)
        : layout_(layout), rows_(rows), right_(rows.count, 3) {
        for (std::size_t i = 0; i < loads.size(); ++i)
            if (rows.of[i] != kFixed) right_.row(rows.of[i]) << loads[i].x, loads[i].y, loads[i].z;
    }

    void add(Index end, Index other, double density) {
        const int row = rows_.of[end];
        if (row == kFixed) return;
        entries_.emplace_back(row, row, density);
        if (rows_.of[other] != kFixed) {
            entries_.emplace_back(row, rows_.of[other], -density);
        } else {
            const Vec3& p = layout_.positions[other];
            right_.row(row) += density * Eigen::RowVector3d(p.x, p.y, p.z);
        }
    }

    Eigen::MatrixX3d solve() const {
        SparseMatrix matrix(rows_.count, rows_.count);
        matrix.setFromTriplets(entries_.begin(), entries_.end());
        const Eigen::SimplicialLDLT<SparseMatrix> factors(matrix);
        if (factors.info() != Eigen::Success || factors.vectorD().minCoeff() <= 0)
            throw Fault(
                FaultKind::invalid,
                "the web's form cannot be found: part of it hangs on no anchor, or its tensions are too far "
                "apart");
        Eigen::MatrixX3d x = factors.solve(right_);
        x += factors.solve(right_ - matrix * x);  // one refinement: the residual is what a web starts with
        return x;
    }

private:
    const Layout& layout_;
    const Rows& rows_;
    std::vector<Eigen::Triplet<double>> entries_;
    Eigen::MatrixX3d right_;
};

}  // namespace

std::vector<Vec3> solve_force_densities(const Layout& layout, std::span<const double> densities,
                                        std::span<const Vec3> loads) {
    const Rows rows = number_free_particles(layout);
    std::vector<Vec3> positions = layout.positions;
    if (rows.count == 0) return positions;
    Equations equations(layout, rows, loads);
    for (std::size_t s = 0; s < layout.pieces.size(); ++s) {
        equations.add(layout.pieces[s].a, layout.pieces[s].b, densities[s]);
        equations.add(layout.pieces[s].b, layout.pieces[s].a, densities[s]);
    }
    const Eigen::MatrixX3d x = equations.solve();
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (rows.of[i] != kFixed) positions[i] = {x(rows.of[i], 0), x(rows.of[i], 1), x(rows.of[i], 2)};
    return positions;
}

namespace {

const Silk& silk_of(const Silks& silks, const Piece& piece) {
    return silks[static_cast<std::size_t>(piece.kind)];
}

double length_of(const Layout& layout, const Piece& piece) {
    return distance(layout.positions[piece.a], layout.positions[piece.b]);
}

/// At which a silk bears `tension`, or the least more that doubles can tell: EA s (1 - a s + b s^2) rises with
/// s for every sound law.
double strain_at(const Silk& silk, double tension) {
    constexpr int kMostRounds = 200;
    const double sought = tension / silk.axial_stiffness;
    if (!law_of(silk, 1).is_curved()) return sought;
    const auto bears = [&](double s) { return s * (1 + s * (silk.stiffening * s - silk.softening)); };
    double low = 0, high = sought;
    while (bears(high) < sought) high *= 2;
    for (int round = 0; round < kMostRounds && low < high; ++round) {
        const double middle = low + (high - low) / 2;
        if (middle == low || middle == high) break;
        (bears(middle) < sought ? low : high) = middle;
    }
    return high;
}

std::vector<double> weigh(const Layout& layout, const Silks& silks, double particle_mass) {
    std::vector<double> mass(layout.positions.size());
    for (const Piece& piece : layout.pieces) {
        const double half = silk_of(silks, piece).linear_density * length_of(layout, piece) / 2;
        mass[piece.a] += half;
        mass[piece.b] += half;
    }
    for (double& each : mass)
        if (each == 0) each = particle_mass;
    return mass;
}

std::vector<Vec3> weights_of(const std::vector<double>& mass, const Vec3& gravity) {
    std::vector<Vec3> weights;
    weights.reserve(mass.size());
    for (const double each : mass) weights.push_back(gravity * each);
    return weights;
}

}  // namespace

mass_spring::MaterialLaw law_of(const Silk& silk, double rest_length) noexcept {
    return {silk.softening / rest_length, silk.stiffening / (rest_length * rest_length),
            silk.hysteresis * silk.axial_stiffness / rest_length, silk.relaxation_time};
}

mass_spring::Network find_form(Layout& layout, const Silks& silks, double particle_mass, double damping,
                               const Vec3& gravity) {
    std::vector<double> densities;
    for (const Piece& piece : layout.pieces)
        densities.push_back(silk_of(silks, piece).tension / length_of(layout, piece));
    layout.positions = solve_force_densities(layout, densities, std::vector<Vec3>(layout.positions.size()));

    mass_spring::Network network;
    network.mass = weigh(layout, silks, particle_mass);
    network.fixed = layout.fixed;
    layout.positions = solve_force_densities(layout, densities, weights_of(network.mass, gravity));
    for (std::size_t s = 0; s < layout.pieces.size(); ++s) {
        const Piece& piece = layout.pieces[s];
        const double length = length_of(layout, piece);
        const Silk& silk = silk_of(silks, piece);
        const double rest = length / (1 + strain_at(silk, densities[s] * length));
        network.springs.push_back(
            {piece.a, piece.b, rest, silk.axial_stiffness / rest, damping, law_of(silk, rest)});
    }
    return network;
}

}  // namespace orbweaver::web
