#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

/// A reference of its own: the snake of Hu and Shelley (2012), "Slithering locomotion", in the plane. A body of
/// unit length and unit mass, which cannot be stretched, has the curvature
///     kappa(s, t) = amplitude cos(waves pi (s + t)),
/// s from the tail to the head, and moves as Newton's law has it under friction of
///     f = -(forward H(u s) + backward (1 - H(u s))) (u s) s - sideways (u n) n
/// times the weight of what slides, u being the direction of its velocity, s and n the body's unit tangent and
/// normal. Lengths are body lengths, times periods. Froude's number is that of forward friction, L/(T^2 mu_f
/// g). Its shape being given, it has three unknowns: where its mass is and how it is turned on the whole.
class PlanarSnake {
public:
    struct Ways {
        double backward = 1.5, sideways = 2;  ///< of forward friction
        double froude = 0.1;
        double amplitude = 7;
        double waves = 2;
        int pieces = 100;
        int steps = 2000;  ///< in a period
    };

    explicit PlanarSnake(const Ways& ways)
        : ways_(ways), place_(static_cast<std::size_t>(ways.pieces)), before_(place_), after_(place_) {}

    /// Body lengths that the middle of mass gets on in a period, after so many, over the `last` of them.
    double speed(int periods, int last) {
        double from[2] = {0, 0};
        for (int i = 0; i < periods * ways_.steps; ++i) {
            if (i == (periods - last) * ways_.steps) from[0] = state_[0], from[1] = state_[1];
            step(i);
        }
        return std::hypot(state_[0] - from[0], state_[1] - from[1]) / last;
    }

private:
    /// Where the mass is, the turn, and their velocities.
    using State = std::array<double, 6>;
    struct Piece {
        double x = 0, y = 0;  ///< of its middle
        double angle = 0;     ///< of its tangent
    };

    /// The shape at a time: pieces about their middle of mass, the mean of their angles 0.
    void shape(double time, std::vector<Piece>& pieces) const {
        const double pi = std::numbers::pi, k = ways_.waves * pi, n = ways_.pieces;
        double mean = 0;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            // The integral of the curvature.
            pieces[i].angle = ways_.amplitude / k * std::sin(k * ((static_cast<double>(i) + 0.5) / n + time));
            mean += pieces[i].angle / n;
        }
        double x = 0, y = 0, middle_x = 0, middle_y = 0;
        for (Piece& piece : pieces) {
            piece.angle -= mean;
            const double dx = std::cos(piece.angle) / n, dy = std::sin(piece.angle) / n;
            piece.x = x + dx / 2, piece.y = y + dy / 2;
            x += dx, y += dy;
            middle_x += piece.x / n, middle_y += piece.y / n;
        }
        for (Piece& piece : pieces) piece.x -= middle_x, piece.y -= middle_y;
    }

    /// Forces and the moment about the middle of mass, each over what it moves, with the shape's moment of
    /// inertia and the moment of momentum that its own motion brings.
    struct Balance {
        double fx = 0, fy = 0, moment = 0, inertia = 0, spin = 0;
    };
    Balance balance(const State& state, double time) {
        constexpr double kSpan = 1e-4;  // of a period, for the shape's velocities
        shape(time, place_);
        shape(time - kSpan, before_);
        shape(time + kSpan, after_);
        const double c = std::cos(state[2]), s = std::sin(state[2]), n = ways_.pieces;
        Balance sum;
        for (std::size_t i = 0; i < place_.size(); ++i) {
            const Piece& p = place_[i];
            const double own_x = (after_[i].x - before_[i].x) / (2 * kSpan);
            const double own_y = (after_[i].y - before_[i].y) / (2 * kSpan);
            sum.inertia += (p.x * p.x + p.y * p.y) / n;
            sum.spin += (p.x * own_y - p.y * own_x) / n;
            const double x = c * p.x - s * p.y, y = s * p.x + c * p.y;
            const double vx = state[3] + c * own_x - s * own_y - state[5] * y;
            const double vy = state[4] + s * own_x + c * own_y + state[5] * x;
            // What slides slower than this, of body lengths a period, is held less: the limit of rest.
            const double speed = std::sqrt(vx * vx + vy * vy + 1e-8);
            const double tx = std::cos(p.angle + state[2]), ty = std::sin(p.angle + state[2]);
            const double along = (vx * tx + vy * ty) / speed, aside = (vy * tx - vx * ty) / speed;
            const double held = (along < 0 ? ways_.backward : 1) * along, turned = ways_.sideways * aside;
            const double fx = -(held * tx - turned * ty) / n, fy = -(held * ty + turned * tx) / n;
            sum.fx += fx / ways_.froude, sum.fy += fy / ways_.froude;
            sum.moment += (x * fy - y * fx) / ways_.froude;
        }
        return sum;
    }

    State slope(const State& state, double time) {
        constexpr double kSpan = 1e-4;
        const Balance now = balance(state, time);
        // d/dt (inertia turn' + spin) = moment
        const Balance earlier = balance(state, time - kSpan), later = balance(state, time + kSpan);
        const double inertia = (later.inertia - earlier.inertia) / (2 * kSpan);
        const double spin = (later.spin - earlier.spin) / (2 * kSpan);
        return {state[3], state[4], state[5],
                now.fx,   now.fy,   (now.moment - inertia * state[5] - spin) / now.inertia};
    }

    /// Heun's.
    void step(int i) {
        const double h = 1.0 / ways_.steps, time = i * h;
        const State first = slope(state_, time);
        State ahead = state_;
        for (std::size_t j = 0; j < 6; ++j) ahead[j] += h * first[j];
        const State second = slope(ahead, time + h);
        for (std::size_t j = 0; j < 6; ++j) state_[j] += h / 2 * (first[j] + second[j]);
    }

    Ways ways_;
    State state_{};
    std::vector<Piece> place_, before_, after_;
};
