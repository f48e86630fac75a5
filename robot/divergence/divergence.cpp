// SPDX-License-Identifier: MIT
#include "robot/divergence/divergence.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "robot/core/modes.h"
#include "robot/kinematics/arm_kinematics.h"
#include "robot/recording/export.h"
#include "robot/simulator/arm/driven_arm.h"
#include "robot/simulator/arm/dynamics.h"

namespace tiller::divergence {

namespace {

using simulator::arm::DrivenArm;
using simulator::arm::Payload;

constexpr double kPeriod = 0.002;     // control period [s]
constexpr double kPeriodCb3 = 0.008;  // [s]
constexpr double kMaxRowStep = 0.1;   // [s], between two rows; the motion in a longer gap is unknown
constexpr int kSettling = 10;         // control periods excluded after initializing the model
constexpr double kGravity = 9.82;     // [m/s2]
constexpr double kMaxJoint = 100;     // [rad], larger values mean a damaged file
constexpr double kMaxMassKg = 1000;   // [kg]
constexpr std::uint64_t kRowsAtOnce = 4096;
constexpr double kTeachButton = 4;  // value of the freedrive button in robot_status_bits

const Quantity kQuantities[kQuantityCount] = {Quantity::JointPosition, Quantity::TcpPosition,
                                              Quantity::JointCurrent, Quantity::TcpForce};

/// The components of a field in a recording, one column each.
struct Field {
    const char* name;
    int count;
    int first = -1;  // first column; -1: not recorded

    bool isThere() const { return first >= 0; }
};

/// The required columns of a recording and the rows read from it.
class Rows {
public:
    explicit Rows(const recording::Recording& recording) : recording_(recording) {
        for (Field* field :
             {&targetQ, &targetQd, &targetMoment, &actualQ, &actualCurrent, &actualPose, &targetPose,
              &tcpOffset, &actualForce, &mass, &centre, &inertia, &robotMode, &statusBits}) {
            find(*field);
        }
    }

    Result<void> read(recording::RowRange range) {
        auto values = recording_.read(columns_, range);
        if (!values) {
            return values.error();
        }
        auto times = recording_.times(range);
        if (!times) {
            return times.error();
        }
        values_ = std::move(*values);
        times_ = std::move(*times);
        return {};
    }
    /// Number of rows read from every column.
    std::size_t count() const {
        std::size_t least = times_.size();
        for (const auto& column : values_) {
            least = std::min(least, column.size());
        }
        return least;
    }
    double time(std::size_t row) const { return times_[row]; }
    double number(const Field& field, std::size_t row, int component = 0) const {
        return values_[static_cast<std::size_t>(field.first + component)][row];
    }
    template <int Size>
    Eigen::Matrix<double, Size, 1> vector(const Field& field, std::size_t row) const {
        Eigen::Matrix<double, Size, 1> values;
        for (int i = 0; i < Size; ++i) {
            values[i] = number(field, row, i);
        }
        return values;
    }

    Field targetQ{"target_q", kJointCount};
    Field targetQd{"target_qd", kJointCount};
    Field targetMoment{"target_moment", kJointCount};
    Field actualQ{"actual_q", kJointCount};
    Field actualCurrent{"actual_current", kJointCount};
    Field actualPose{"actual_TCP_pose", 6};
    Field targetPose{"target_TCP_pose", 6};
    Field tcpOffset{"tcp_offset", 6};
    Field actualForce{"actual_TCP_force", 6};
    Field mass{"payload", 1};
    Field centre{"payload_cog", 3};
    Field inertia{"payload_inertia", 6};
    Field robotMode{"robot_mode", 1};
    Field statusBits{"robot_status_bits", 1};

private:
    void find(Field& field) {
        std::vector<std::size_t> found;
        for (int i = 0; i < field.count; ++i) {
            const std::string name = field.count == 1 ? std::string(field.name)
                                                      : std::string(field.name) + '_' + std::to_string(i);
            if (const auto column = recording_.indexOf(name)) {
                found.push_back(*column);
            }
        }
        if (found.size() == static_cast<std::size_t>(field.count)) {
            field.first = static_cast<int>(columns_.size());
            columns_.insert(columns_.end(), found.begin(), found.end());
        }
    }

    const recording::Recording& recording_;
    std::vector<std::size_t> columns_;
    std::vector<std::vector<double>> values_;
    std::vector<double> times_;
};

bool isPlausible(const Vector6& q) {
    return q.allFinite() && q.cwiseAbs().maxCoeff() < kMaxJoint;
}

/// Payload of the row; empty if it is missing or implausible.
std::optional<Payload> payloadAt(const Rows& rows, std::size_t row) {
    Payload payload;
    payload.mass = rows.number(rows.mass, row);
    payload.centreOfGravity = rows.vector<3>(rows.centre, row);
    if (rows.inertia.isThere()) {
        const Vector6 inertia = rows.vector<6>(rows.inertia, row);
        payload.inertia = inertia.allFinite() ? inertia : Vector6::Zero();
    }
    const bool sane = payload.mass >= 0 && payload.mass < kMaxMassKg && payload.centreOfGravity.allFinite() &&
                      payload.centreOfGravity.norm() < kMaxMassKg;
    return sane ? std::optional(payload) : std::nullopt;
}

/// The mounting of the arm is not recorded. It is derived from the target torques at standstill, which are a
/// linear function of gravity in the base frame.
Result<Eigen::Vector3d> gravityOf(Rows& rows, const RobotModel& model, recording::RowRange range) {
    constexpr std::uint64_t kSpots = 40;
    constexpr double kStanding = 1e-4;  // [rad/s]
    constexpr double kOffBy = 0.7;      // [m/s2], with a larger error the model does not explain the torques
    constexpr double kTilted = 0.05;    // [rad]
    const Eigen::Vector3d upright(0, 0, kGravity);
    if (!rows.targetMoment.isThere() || !rows.targetQd.isThere() || !rows.mass.isThere() ||
        !rows.centre.isThere()) {
        return upright;
    }
    simulator::arm::Dynamics dynamics(model);
    std::vector<Vector6> torques;
    std::vector<Eigen::Matrix<double, 6, 3>> perGravity;
    for (std::uint64_t spot = 0; spot < kSpots; ++spot) {
        if (const auto read = rows.read({range.first + spot * range.count / kSpots, 1}); !read) {
            return read.error();
        }
        if (rows.count() == 0) {
            continue;
        }
        const Vector6 q = rows.vector<6>(rows.targetQ, 0);
        const Vector6 qd = rows.vector<6>(rows.targetQd, 0);
        const Vector6 torque = rows.vector<6>(rows.targetMoment, 0);
        const auto payload = payloadAt(rows, 0);
        const bool standing = qd.allFinite() && qd.cwiseAbs().maxCoeff() < kStanding;
        if (!payload || !standing || !isPlausible(q) || !torque.allFinite() || torque.isZero(0)) {
            continue;
        }
        dynamics.setPayload(*payload);
        Eigen::Matrix<double, 6, 3> each;
        for (int axis = 0; axis < 3; ++axis) {
            dynamics.setGravity(Eigen::Vector3d::Unit(axis));
            each.col(axis) = dynamics.gravityTorques(q);
        }
        torques.push_back(torque);
        perGravity.push_back(each);
    }
    if (torques.empty()) {
        return upright;
    }
    Eigen::MatrixXd matrix(6 * static_cast<Eigen::Index>(torques.size()), 3);
    Eigen::VectorXd right(matrix.rows());
    for (std::size_t i = 0; i < torques.size(); ++i) {
        matrix.middleRows<6>(6 * static_cast<Eigen::Index>(i)) = perGravity[i];
        right.segment<6>(6 * static_cast<Eigen::Index>(i)) = torques[i];
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(matrix);
    const Eigen::Vector3d found = solver.solve(right);
    const bool explains =
        solver.rank() == 3 && found.allFinite() && std::abs(found.norm() - kGravity) < kOffBy;
    if (!explains || std::acos(std::clamp(found.z() / found.norm(), -1.0, 1.0)) < kTilted) {
        return upright;
    }
    return Eigen::Vector3d(found.normalized() * kGravity);
}

/// Determines the models whose kinematics explain the recorded TCP poses: with such a model, the TCP offset
/// computed from the pose and the joint positions equals the recorded offset, or is at least the same in all
/// rows. The poses of a calibrated arm differ from those of its nominal model by millimetres, and from those
/// of other models by centimetres.
/// Returns  empty if the poses fit no model, e.g. because of a tool change, or were not recorded
Result<std::vector<RobotModelId>> modelsFitting(Rows& rows, recording::RowRange range) {
    constexpr std::uint64_t kSpots = 100;
    constexpr double kCalibration = 0.01;  // [m], maximum error of the nominal model
    constexpr double kRounding = 0.0002;   // [m], for tables with few digits
    constexpr double kDistinct =
        5;  // minimum ratio between the errors of a wrong model and of the right model
    const bool hasTargets = rows.targetPose.isThere();
    if (!hasTargets && !rows.actualPose.isThere()) {
        return std::vector<RobotModelId>();
    }
    const Field& joints = hasTargets ? rows.targetQ : rows.actualQ;
    const Field& pose = hasTargets ? rows.targetPose : rows.actualPose;
    const auto& models = robotModels();
    std::vector<std::optional<Eigen::Vector3d>> references(models.size());
    std::vector<double> errors(models.size());
    for (std::uint64_t spot = 0; spot < kSpots; ++spot) {
        if (const auto read = rows.read({range.first + spot * range.count / kSpots, 1}); !read) {
            return read.error();
        }
        if (rows.count() == 0) {
            continue;
        }
        const JointPositions q(rows.vector<6>(joints, 0));
        const Vector6 values = rows.vector<6>(pose, 0);
        const bool offsetKnown = rows.tcpOffset.isThere();
        const Eigen::Vector3d recorded =
            offsetKnown ? rows.vector<3>(rows.tcpOffset, 0) : Eigen::Vector3d::Zero().eval();
        if (!isPlausible(q.values) || !isPlausible(values) || !recorded.allFinite()) {
            continue;
        }
        for (std::size_t i = 0; i < models.size(); ++i) {
            const Eigen::Vector3d offset =
                kinematics::forward(models[i].dh, q).inverse() * Eigen::Vector3d(values.head<3>());
            if (!references[i]) {
                references[i] = offset;
            }
            errors[i] = std::max(errors[i], (offset - (offsetKnown ? recorded : *references[i])).norm());
        }
    }
    std::vector<RobotModelId> fitting;
    const double least = *std::min_element(errors.begin(), errors.end());
    if (!references.front() || least > kCalibration) {
        return fitting;
    }
    for (std::size_t i = 0; i < models.size(); ++i) {
        if (errors[i] <= std::max(kRounding, kDistinct * least)) {
            fitting.push_back(models[i].id);
        }
    }
    return fitting;
}

/// Compares the selected model with the model named in the recording, and with the recorded TCP poses.
void identify(Report& report, const std::vector<RobotModelId>& fitting, std::optional<RobotModelId> stated) {
    const DhParameters& dh = robotModel(report.model).dh;
    const bool fits = std::find(fitting.begin(), fitting.end(), report.model) != fitting.end();
    if (!fitting.empty() && !fits) {
        report.otherModel = stated && *stated != report.model ? *stated : fitting.front();
    } else if (stated && *stated != report.model) {
        report.otherModel = stated;
    }
    // Models with the same kinematics differ only in the payload that they can carry.
    const bool fitsOnlyThis = fits && std::all_of(fitting.begin(), fitting.end(), [&](RobotModelId each) {
                                  return robotModel(each).dh == dh;
                              });
    report.isModelConfirmed = !report.otherModel && (stated == report.model || fitsOnlyThis);
}

/// Detects the first period during which a value exceeds its limit.
class Stretch {
public:
    /// Returns  the period once it has lasted long enough: its start, and the maximum so far
    std::optional<Difference> see(const Difference& now, double limit, double lasting) {
        if (!(now.amount > limit)) {
            begun_.reset();
            return std::nullopt;
        }
        if (!begun_) {
            begun_ = now;
        }
        begun_->amount = std::max(begun_->amount, now.amount);
        // The tolerance compensates for rounding, because times are sums of periods.
        return now.seconds - begun_->seconds >= lasting * (1 - 1e-6) ? begun_ : std::nullopt;
    }
    void end() { begun_.reset(); }

private:
    std::optional<Difference> begun_;
};

/// Compares the arm with the model, row by row.
class Comparison {
public:
    Comparison(const Rows& rows, const RobotModel& model, const Limits& limits, Report& report)
        : rows_(rows), limits_(limits), report_(report), arm_(model, model.isCb3() ? kPeriodCb3 : kPeriod) {
        arm_.setGravity(report.gravity);
        for (const Quantity quantity : kQuantities) {
            Outcome& outcome = outcomeOf(quantity);
            outcome.quantity = quantity;
            outcome.limit = limits.of(quantity);
        }
        need(Quantity::TcpPosition, rows.actualPose);
        if (!rows.tcpOffset.isThere()) {
            need(Quantity::TcpPosition, rows.targetPose);
        }
        need(Quantity::JointCurrent, rows.actualCurrent);
        need(Quantity::JointCurrent, rows.mass);
        need(Quantity::JointCurrent, rows.centre);
        need(Quantity::TcpForce, rows.actualForce);
    }

    /// row     index among the rows read
    /// number  row number in the recording
    void look(std::size_t row, std::uint64_t number) {
        ++report_.rows;
        JointPositions q(rows_.vector<6>(rows_.targetQ, row));
        const double time = rows_.time(row);
        if (!isPlausible(q.values) || !isDriven(row)) {
            leaveOut();
            return;
        }
        if (!last_ || !(time - last_->time <= kMaxRowStep)) {
            arm_.place(q);
            settling_ = kSettling;
            last_.reset();
            for (auto& stretches : stretches_) {
                std::for_each(stretches.begin(), stretches.end(), [](Stretch& each) { each.end(); });
            }
        }
        follow({time, q, velocityAt(row, q, time)}, payloadOf(row));
        if (settling_ > 0) {
            --settling_;
            ++report_.leftOut;
            return;
        }
        report_.firstCompared = report_.firstCompared.value_or(number);
        compareJoints(row, number);
        compareTcp(row, number);
    }

private:
    struct Target {
        double time;
        JointPositions q;
        JointVelocities qd;
    };

    Outcome& outcomeOf(Quantity quantity) { return report_.outcomes[static_cast<std::size_t>(quantity)]; }
    bool isCompared(Quantity quantity) {
        const Outcome& outcome = outcomeOf(quantity);
        return outcome.limit > 0 && outcome.missing.empty();
    }
    void need(Quantity quantity, const Field& field) {
        if (!field.isThere()) {
            outcomeOf(quantity).missing.emplace_back(field.name);
        }
    }

    /// True if the drives hold the arm and it is not being guided by hand.
    bool isDriven(std::size_t row) const {
        const bool running = !rows_.robotMode.isThere() ||
                             rows_.number(rows_.robotMode, row) == static_cast<double>(RobotMode::Running);
        const double bits = rows_.statusBits.isThere() ? rows_.number(rows_.statusBits, row) : 0;
        const bool led =
            std::fmod(std::isfinite(bits) ? std::abs(bits) : 0, 2 * kTeachButton) >= kTeachButton;
        return running && !led;
    }
    void leaveOut() {
        ++report_.leftOut;
        last_.reset();
    }

    JointVelocities velocityAt(std::size_t row, const JointPositions& q, double time) const {
        if (rows_.targetQd.isThere()) {
            const Vector6 qd = rows_.vector<6>(rows_.targetQd, row);
            return JointVelocities(isPlausible(qd) ? qd : Vector6::Zero());
        }
        const bool moved = last_ && time > last_->time;
        return JointVelocities(moved ? Vector6((q.values - last_->q.values) / (time - last_->time))
                                     : Vector6::Zero());
    }
    std::optional<Payload> payloadOf(std::size_t row) {
        return isCompared(Quantity::JointCurrent) ? payloadAt(rows_, row) : std::nullopt;
    }

    /// Moves the model to this target, interpolating targets that were not recorded.
    void follow(const Target& to, const std::optional<Payload>& payload) {
        payloadKnown_ = payload.has_value();
        if (payload) {
            arm_.setPayload(*payload);
        }
        const double between = last_ ? to.time - last_->time : 0;
        const int steps = std::max(1, static_cast<int>(std::lround(between / arm_.period())));
        for (int step = 1; step < steps; ++step) {
            const double part = static_cast<double>(step) / steps;
            arm_.step(last_->q + part * (to.q - last_->q), last_->qd + part * (to.qd - last_->qd));
        }
        arm_.step(to.q, to.qd);
        last_ = to;
    }

    void compareJoints(std::size_t row, std::uint64_t number) {
        const auto& state = arm_.state();
        if (isCompared(Quantity::JointPosition)) {
            judgeJoints(Quantity::JointPosition, row, number,
                        rows_.vector<6>(rows_.actualQ, row) - state.actualQ.values);
        }
        if (isCompared(Quantity::JointCurrent) && payloadKnown_) {
            judgeJoints(Quantity::JointCurrent, row, number,
                        rows_.vector<6>(rows_.actualCurrent, row) - state.actualCurrent);
        }
    }
    void compareTcp(std::size_t row, std::uint64_t number) {
        const auto& state = arm_.state();
        if (isCompared(Quantity::TcpPosition)) {
            if (const auto offset = tcpOffsetAt(row)) {
                const Eigen::Isometry3d T_base_tcp =
                    kinematics::forward(arm_.model().dh, state.actualQ) * *offset;
                judgeTcp(Quantity::TcpPosition, row, number,
                         rows_.vector<3>(rows_.actualPose, row) - T_base_tcp.translation());
            }
        }
        if (isCompared(Quantity::TcpForce)) {
            judgeTcp(Quantity::TcpForce, row, number,
                     rows_.vector<3>(rows_.actualForce, row) - state.tcpForce.force);
        }
    }
    /// TCP offset in a row. Computed from the controller's target TCP pose, which includes the calibration of
    /// the arm. If there is no target pose, the recorded TCP offset is used.
    std::optional<Eigen::Isometry3d> tcpOffsetAt(std::size_t row) const {
        const Field& field = rows_.targetPose.isThere() ? rows_.targetPose : rows_.tcpOffset;
        const Vector6 values = rows_.vector<6>(field, row);
        if (!values.allFinite()) {
            return std::nullopt;
        }
        const Eigen::Isometry3d T = Pose(values.head<3>(), values.tail<3>()).transform();
        return rows_.targetPose.isThere() ? kinematics::forward(arm_.model().dh, last_->q).inverse() * T : T;
    }

    void judgeJoints(Quantity quantity, std::size_t row, std::uint64_t number, const Vector6& apart) {
        bool any = false;
        for (int joint = 0; joint < kJointCount; ++joint) {
            any = judge({quantity, joint, number, rows_.time(row), std::abs(apart[joint])}) || any;
        }
        outcomeOf(quantity).rows += any ? 1 : 0;
    }
    void judgeTcp(Quantity quantity, std::size_t row, std::uint64_t number, const Eigen::Vector3d& apart) {
        outcomeOf(quantity).rows += judge({quantity, -1, number, rows_.time(row), apart.norm()}) ? 1 : 0;
    }
    /// Returns  false if a value is missing
    bool judge(const Difference& now) {
        if (!std::isfinite(now.amount)) {
            return false;
        }
        Outcome& outcome = outcomeOf(now.quantity);
        if (!outcome.greatest || now.amount > outcome.greatest->amount) {
            outcome.greatest = now;
        }
        const auto place = static_cast<std::size_t>(std::max(now.joint, 0));
        Stretch& stretch = stretches_[static_cast<std::size_t>(now.quantity)][place];
        const auto found = stretch.see(now, outcome.limit, limits_.lasting);
        // If several joints diverge in the same row, report the joint with the largest deviation. For a single
        // joint, report its maximum.
        if (found && (!outcome.parted || found->row < outcome.parted->row ||
                      (found->row == outcome.parted->row && found->amount > outcome.parted->amount))) {
            outcome.parted = found;
        }
        return true;
    }

    const Rows& rows_;
    const Limits limits_;
    Report& report_;
    DrivenArm arm_;
    std::optional<Target> last_;
    int settling_ = 0;
    bool payloadKnown_ = false;
    std::array<std::array<Stretch, kJointCount>, kQuantityCount> stretches_{};
};

Error refuse(const recording::Recording& recording, ErrorCode code, const QString& why) {
    return {code, QStringLiteral("compare %1 with the arm model").arg(recording.path()), why};
}

QString statedModel(const recording::Recording& recording) {
    const auto fact = recording.facts().find("model");
    return fact == recording.facts().end() ? QString() : QString::fromStdString(fact->second);
}

Result<RobotModelId> modelOf(const recording::Recording& recording, const Choice& choice) {
    if (choice.model) {
        return *choice.model;
    }
    const QString said = statedModel(recording);
    if (const auto model = robotModelByName(said)) {
        return *model;
    }
    return refuse(recording, ErrorCode::InvalidArgument,
                  said.isEmpty()
                      ? QStringLiteral("the recording contains no robot model: select a model")
                      : QStringLiteral("unknown robot model \"%1\": select a similar model").arg(said));
}

}  // namespace

double Limits::of(Quantity quantity) const {
    switch (quantity) {
        case Quantity::JointPosition:
            return jointPosition;
        case Quantity::TcpPosition:
            return tcpPosition;
        case Quantity::JointCurrent:
            return current;
        case Quantity::TcpForce:
            return force;
    }
    return 0;
}

std::optional<Difference> Report::first() const {
    std::optional<Difference> first;
    for (const Outcome& outcome : outcomes) {
        if (outcome.parted && (!first || outcome.parted->row < first->row)) {
            first = outcome.parted;
        }
    }
    return first;
}

Result<Report> compare(const recording::Recording& recording, const Choice& choice) {
    for (const double limit : {choice.limits.jointPosition, choice.limits.tcpPosition, choice.limits.current,
                               choice.limits.force, choice.limits.lasting}) {
        if (!std::isfinite(limit) || limit < 0) {
            return refuse(recording, ErrorCode::InvalidArgument,
                          QStringLiteral("a limit must be a number of 0 or more"));
        }
    }
    Rows rows(recording);
    QStringList missing;
    for (const Field& field : {rows.targetQ, rows.actualQ}) {
        missing << (field.isThere() ? QStringList() : QStringList(QLatin1String(field.name)));
    }
    if (!missing.isEmpty()) {
        return refuse(recording, ErrorCode::FieldUnknown,
                      QStringLiteral("the recording has no %1: record all fields to an MCAP file")
                          .arg(missing.join(QStringLiteral(", "))));
    }
    const auto model = modelOf(recording, choice);
    if (!model) {
        return model.error();
    }
    if (recording.period() > kMaxRowStep) {
        return refuse(recording, ErrorCode::InvalidArgument,
                      QStringLiteral("the rows of the recording are %1 s apart, so the motion between them "
                                     "is unknown: record every packet")
                          .arg(recording.period()));
    }
    recording::ExportChoice part;
    part.from = choice.from;
    part.until = choice.until;
    const auto range = recording::chooseRows(recording, part);
    if (!range) {
        return range.error();
    }
    Report report;
    report.model = *model;
    if (range->count > 0) {
        const auto gravity = gravityOf(rows, robotModel(*model), *range);
        if (!gravity) {
            return gravity.error();
        }
        report.gravity = *gravity;
        const auto fitting = modelsFitting(rows, *range);
        if (!fitting) {
            return fitting.error();
        }
        identify(report, *fitting, robotModelByName(statedModel(recording)));
    }
    Comparison comparison(rows, robotModel(*model), choice.limits, report);
    for (std::uint64_t done = 0; done < range->count; done += kRowsAtOnce) {
        if (choice.progress &&
            !choice.progress(static_cast<double>(done) / static_cast<double>(range->count))) {
            return refuse(recording, ErrorCode::Cancelled, {});
        }
        const std::uint64_t first = range->first + done;
        if (const auto read = rows.read({first, std::min(kRowsAtOnce, range->count - done)}); !read) {
            return read.error();
        }
        for (std::size_t row = 0; row < rows.count(); ++row) {
            comparison.look(row, first + row);
        }
    }
    return report;
}

}  // namespace tiller::divergence
