// A closed loop: a Kalman filter finds its way over the Moon by what its camera sees. The same loop, with the same result, as
// clients/python/examples/closed_loop.py, which explains it:  closed_loop http://127.0.0.1:8810 [FRAMES]
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <tuple>

#include "msisf.hpp"

namespace {

constexpr double mu = 4.902800066e12;  // m^3/s^2, gravity of the Moon (JPL DE421)
constexpr double spin = 2.6617e-6;     // rad/s, of the frame MOON_ME about z
constexpr double sphere = 1737400.0;   // m
constexpr double step = 5.0;           // s between pictures
constexpr int pixels = 128, half_patch = 8, search = 6, landmarks = 8;
constexpr double pixel_noise = 0.4;          // px
constexpr double acceleration_noise = 1e-4;  // m/s^2
constexpr double degrees = 3.14159265358979323846 / 180.0;

using Vector3 = std::array<double, 3>;
using Vector6 = std::array<double, 6>;

double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double length(const Vector3& a) { return std::sqrt(dot(a, a)); }
Vector3 cross(const Vector3& a, const Vector3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector3 position_of(const Vector6& state) { return {state[0], state[1], state[2]}; }

Vector6 plus(const Vector6& a, double factor, const Vector6& b) {
    Vector6 sum;
    for (int k = 0; k < 6; k++) sum[k] = a[k] + factor * b[k];
    return sum;
}

/// Motion in the frame that turns with the Moon.
Vector6 rate(const Vector6& s) {
    const double distance = length(position_of(s)), pull = -mu / (distance * distance * distance);
    return {s[3], s[4], s[5], pull * s[0] + 2.0 * spin * s[4] + spin * spin * s[0], pull * s[1] - 2.0 * spin * s[3] + spin * spin * s[1],
            pull * s[2]};
}

/// One step of Runge and Kutta's fourth order.
Vector6 propagate(const Vector6& state) {
    const Vector6 k1 = rate(state), k2 = rate(plus(state, 0.5 * step, k1)), k3 = rate(plus(state, 0.5 * step, k2));
    const Vector6 k4 = rate(plus(state, step, k3));
    return plus(plus(plus(plus(state, step / 6.0, k1), step / 3.0, k2), step / 3.0, k3), step / 6.0, k4);
}

/// Columns: against the line of sight, right, up; of a camera that looks to the Moon's centre, north up.
std::array<Vector3, 3> axes_at(const Vector3& position) {
    const double distance = length(position);
    const Vector3 up{position[0] / distance, position[1] / distance, position[2] / distance};
    Vector3 east = cross({0.0, 0.0, 1.0}, up);
    const double size = length(east);
    for (double& part : east) part /= size;
    return {up, east, cross(up, east)};
}

std::array<double, 4> quaternion_of(const std::array<Vector3, 3>& m) {  // of the columns
    const double trace = m[0][0] + m[1][1] + m[2][2], q0 = 0.5 * std::sqrt(std::max(0.0, 1.0 + trace));
    if (q0 > 1e-3) {
        return {(m[1][2] - m[2][1]) / (4.0 * q0), (m[2][0] - m[0][2]) / (4.0 * q0), (m[0][1] - m[1][0]) / (4.0 * q0), q0};
    }
    std::array<double, 4> q{};
    for (int k = 0; k < 3; k++) q[k] = std::sqrt(std::max(0.0, (1.0 + m[k][k]) / 2.0));
    return q;
}

/// A matrix by rows.
struct Matrix {
    int rows, columns;
    std::vector<double> values;
    Matrix(int rows_, int columns_) : rows(rows_), columns(columns_), values(static_cast<std::size_t>(rows_ * columns_)) {}
    double& operator()(int row, int column) { return values[static_cast<std::size_t>(row * columns + column)]; }
    double operator()(int row, int column) const { return values[static_cast<std::size_t>(row * columns + column)]; }
};

Matrix operator*(const Matrix& a, const Matrix& b) {
    Matrix product(a.rows, b.columns);
    for (int i = 0; i < a.rows; i++) {
        for (int k = 0; k < a.columns; k++) {
            for (int j = 0; j < b.columns; j++) product(i, j) += a(i, k) * b(k, j);
        }
    }
    return product;
}

Matrix transposed(const Matrix& a) {
    Matrix turned(a.columns, a.rows);
    for (int i = 0; i < a.rows; i++) {
        for (int j = 0; j < a.columns; j++) turned(j, i) = a(i, j);
    }
    return turned;
}

/// Solves a x = b for a symmetric positive definite matrix, by Cholesky.
Matrix solve(Matrix a, Matrix b) {
    for (int j = 0; j < a.rows; j++) {
        for (int k = 0; k < j; k++) a(j, j) -= a(j, k) * a(j, k);
        a(j, j) = std::sqrt(a(j, j));
        for (int i = j + 1; i < a.rows; i++) {
            for (int k = 0; k < j; k++) a(i, j) -= a(i, k) * a(j, k);
            a(i, j) /= a(j, j);
        }
    }
    for (int c = 0; c < b.columns; c++) {
        for (int i = 0; i < a.rows; i++) {
            for (int k = 0; k < i; k++) b(i, c) -= a(i, k) * b(k, c);
            b(i, c) /= a(i, i);
        }
        for (int i = a.rows - 1; i >= 0; i--) {
            for (int k = i + 1; k < a.rows; k++) b(i, c) -= a(k, i) * b(k, c);
            b(i, c) /= a(i, i);
        }
    }
    return b;
}

struct Spot {
    double strength;
    int x, y;
};

/// The spots with most contrast in both directions, one in each cell of a grid, the strongest first.
std::vector<Spot> corners(const msisf::Image& image) {
    const auto level = [&](int x, int y) { return static_cast<double>(image.level(static_cast<unsigned>(x), static_cast<unsigned>(y))); };
    const auto slope = [&](int x, int y, bool down) {  // as numpy's gradient: one-sided at the border
        const int at = down ? y : x, low = std::max(at - 1, 0), high = std::min(at + 1, pixels - 1);
        return (down ? level(x, high) - level(x, low) : level(high, y) - level(low, y)) / (high - low);
    };
    Matrix xx(pixels, pixels), yy(pixels, pixels), xy(pixels, pixels);
    for (int y = 0; y < pixels; y++) {
        for (int x = 0; x < pixels; x++) {
            const double dx = slope(x, y, false), dy = slope(x, y, true);
            xx(y, x) = dx * dx, yy(y, x) = dy * dy, xy(y, x) = dx * dy;
        }
    }
    const auto box = [](const Matrix& values, int x, int y) {
        double sum = 0.0;
        for (int row = std::max(y - 3, 0); row <= std::min(y + 3, pixels - 1); row++) {
            for (int column = std::max(x - 3, 0); column <= std::min(x + 3, pixels - 1); column++) sum += values(row, column);
        }
        return sum;
    };
    constexpr int border = half_patch + search + 1, cell = pixels / 4;
    std::vector<Spot> found;
    for (int top = border; top < pixels - border - 1; top += cell) {
        for (int left = border; left < pixels - border - 1; left += cell) {
            Spot best{-1e300, left, top};
            for (int y = top; y < std::min(top + cell, pixels - border); y++) {
                for (int x = left; x < std::min(left + cell, pixels - border); x++) {
                    const double mixed = box(xy, x, y), strength = box(xx, x, y) * box(yy, x, y) - mixed * mixed;
                    if (strength > best.strength) best = {strength, x, y};
                }
            }
            found.push_back(best);
        }
    }
    std::sort(found.begin(), found.end(), [](const Spot& a, const Spot& b) { return std::tie(a.strength, a.x, a.y) > std::tie(b.strength, b.x, b.y); });
    found.resize(std::min<std::size_t>(found.size(), landmarks));
    return found;
}

/// Where the parabola through three values has its top.
double vertex(double before, double middle, double after) {
    const double curvature = before - 2.0 * middle + after;
    return curvature < 0.0 ? 0.5 * (before - after) / curvature : 0.0;
}

/// Where a spot of the expected picture is in the seen one; whether it is alike enough.
bool find(const Spot& spot, const msisf::Image& expected, const msisf::Image& seen, double& x, double& y) {
    constexpr int size = 2 * half_patch + 1, count = size * size, shifts = 2 * search + 1;
    std::vector<double> patch;
    double mean = 0.0, square = 0.0;
    for (int row = -half_patch; row <= half_patch; row++) {
        for (int column = -half_patch; column <= half_patch; column++) {
            patch.push_back(expected.level(static_cast<unsigned>(spot.x + column), static_cast<unsigned>(spot.y + row)));
            mean += patch.back() / count;
        }
    }
    for (double& value : patch) value -= mean, square += value * value;
    Matrix likeness(shifts, shifts);
    int best_row = 0, best_column = 0;
    for (int row = 0; row < shifts; row++) {
        for (int column = 0; column < shifts; column++) {
            double product = 0.0, sum = 0.0, squares = 0.0;
            std::size_t k = 0;
            for (int b = -half_patch; b <= half_patch; b++) {
                for (int a = -half_patch; a <= half_patch; a++) {
                    const double value = seen.level(
                        static_cast<unsigned>(spot.x + column - search + a), static_cast<unsigned>(spot.y + row - search + b));
                    product += value * patch[k++], sum += value, squares += value * value;
                }
            }
            likeness(row, column) = product / (std::sqrt(std::max(squares - sum * sum / count, 0.0) * square) + 1e-9);
            if (likeness(row, column) > likeness(best_row, best_column)) best_row = row, best_column = column;
        }
    }
    if (best_row == 0 || best_row == shifts - 1 || best_column == 0 || best_column == shifts - 1) return false;
    const double top = likeness(best_row, best_column);
    x = spot.x + best_column - search + vertex(likeness(best_row, best_column - 1), top, likeness(best_row, best_column + 1));
    y = spot.y + best_row - search + vertex(likeness(best_row - 1, best_column), top, likeness(best_row + 1, best_column));
    return top > 0.8;
}

/// An extended Kalman filter of position and velocity.
struct Filter {
    Vector6 state;
    Matrix covariance{6, 6};

    void predict() {
        const Vector6 after = propagate(state);
        Matrix transition(6, 6);
        for (int k = 0; k < 6; k++) {
            const double change = k < 3 ? 1.0 : 1e-3;
            Vector6 moved = state;
            moved[k] += change;
            moved = propagate(moved);
            for (int row = 0; row < 6; row++) transition(row, k) = (moved[row] - after[row]) / change;
        }
        state = after;
        covariance = transition * covariance * transposed(transition);
        for (int k = 0; k < 3; k++) {
            const double far = 0.5 * step * step * acceleration_noise, fast = step * acceleration_noise;
            covariance(k, k) += far * far, covariance(k + 3, k + 3) += fast * fast;
            covariance(k, k + 3) += far * fast, covariance(k + 3, k) += far * fast;
        }
    }

    /// Corrects by points that are seen at pixels (counted from 0) by a camera with these axes at the state's position.
    void update(const std::array<Vector3, 3>& axes, const std::vector<Vector3>& points, const std::vector<std::array<double, 2>>& seen) {
        const double focal = 0.5 * pixels / std::tan(20.0 * degrees);
        const int count = static_cast<int>(points.size());
        const Vector3 right = axes[1], down{-axes[2][0], -axes[2][1], -axes[2][2]}, ahead{-axes[0][0], -axes[0][1], -axes[0][2]};
        Matrix design(2 * count, 6), innovation(2 * count, 1);
        for (int k = 0; k < count; k++) {
            Vector3 ray;
            for (int part = 0; part < 3; part++) ray[part] = points[k][part] - state[part];
            const double x = dot(right, ray), y = dot(down, ray), z = dot(ahead, ray);
            innovation(2 * k, 0) = seen[k][0] - (focal * x / z + 0.5 * (pixels - 1));
            innovation(2 * k + 1, 0) = seen[k][1] - (focal * y / z + 0.5 * (pixels - 1));
            for (int part = 0; part < 3; part++) {
                design(2 * k, part) = -(focal / z * right[part] - focal * x / (z * z) * ahead[part]);
                design(2 * k + 1, part) = -(focal / z * down[part] - focal * y / (z * z) * ahead[part]);
            }
        }
        const Matrix seen_covariance = design * covariance;
        Matrix total = seen_covariance * transposed(design);
        for (int k = 0; k < total.rows; k++) total(k, k) += pixel_noise * pixel_noise;
        const Matrix gain = transposed(solve(total, seen_covariance)), change = gain * innovation, part = gain * seen_covariance;
        for (int row = 0; row < 6; row++) {
            state[row] += change(row, 0);
            for (int column = 0; column < 6; column++) covariance(row, column) -= part(row, column);
        }
    }
};

/// Flies; returns the error of the position after each frame, m.
std::vector<double> run(const msisf::Server& server, int frames) {
    const std::string camera = R"("width": 128, "height": 128, "fov": 40)", options = "{" + camera + R"(, "bit-depth": 16})";
    double mjd = 55289.0;
    const std::string sun = server.get("/v1/sun?mjd=55289");
    const double start = (std::stod(msisf::detail::json_text(sun.substr(sun.find("sub_solar_point")), "longitude")) - 75.0) * degrees;
    const double radius = sphere + 400e3, speed = std::sqrt(mu / radius) - spin * radius;
    Vector6 truth{radius * std::cos(start), radius * std::sin(start), 0.0, -speed * std::sin(start), speed * std::cos(start), 0.0};
    Filter believed{plus(truth, 1.0, {1500.0, -1200.0, 1000.0, 0.5, -0.5, 0.5})};
    for (int k = 0; k < 6; k++) believed.covariance(k, k) = k < 3 ? 2000.0 * 2000.0 : 1.0;
    std::vector<double> errors;
    msisf::Stream eye(server, options), mind(server, options);
    for (int frame = 0; frame < frames; frame++) {
        const auto axes = axes_at(position_of(truth));
        const auto turn = quaternion_of(axes);
        const msisf::State belief{mjd, position_of(believed.state), turn};
        const msisf::Image seen = eye.render({mjd, position_of(truth), turn}), expected = mind.render(belief);
        std::vector<Spot> spots;
        std::vector<std::array<double, 2>> matches;
        for (const Spot& spot : corners(expected)) {
            double x = 0.0, y = 0.0;
            if (find(spot, expected, seen, x, y)) spots.push_back(spot), matches.push_back({x, y});
        }
        if (!spots.empty()) {
            const msisf::Layer position = server.layer("{" + camera + ", " + msisf::json(belief) + "}", "position");
            std::vector<Vector3> points;
            std::vector<std::array<double, 2>> kept;
            for (std::size_t k = 0; k < spots.size(); k++) {
                const auto part = [&](unsigned plane) {
                    return position.at(static_cast<unsigned>(spots[k].x), static_cast<unsigned>(spots[k].y), plane);
                };
                if (!std::isnan(part(0))) points.push_back({part(0), part(1), part(2)}), kept.push_back(matches[k]);
            }
            believed.update(axes, points, kept);
        }
        double square = 0.0;
        for (int k = 0; k < 3; k++) square += (believed.state[k] - truth[k]) * (believed.state[k] - truth[k]);
        errors.push_back(std::sqrt(square));
        truth = propagate(truth);
        believed.predict();
        mjd += step / 86400.0;
    }
    return errors;
}

}  // namespace

int main(int count, char** words) {
    if (count < 2 || count > 3 || (count == 3 && std::atoi(words[2]) < 1)) {
        std::cerr << "usage: closed_loop ADDRESS [FRAMES]\n";
        return 1;
    }
    try {
        const std::vector<double> errors = run(msisf::Server(words[1]), count == 3 ? std::atoi(words[2]) : 300);
        std::cout << "error of the position: " << std::lround(errors.front()) << " m after the first frame, " << std::lround(errors.back())
                  << " m after the last\n";
    } catch (const msisf::Error& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
}
