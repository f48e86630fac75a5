// SPDX-License-Identifier: MIT
#include "robot/station/program/recover/recovery_map.h"

#include <QSet>
#include <algorithm>
#include <bit>
#include <map>
#include <utility>

#include "robot/station/program/preview/simulated_run.h"
#include "robot/station/program/program_edit.h"
#include "robot/station/program/program_text.h"
#include "robot/station/program/step_kind.h"

namespace tiller::program {
namespace {

using project::ProgramStep;
using simulator::ControllerState;

constexpr int kOutputs = 18;
constexpr int kCheckedIterations = 2;   // number of checked iterations of an endless loop
constexpr double kSamePosition = 1e-4;  // [rad] for each joint
constexpr double kAtStartPosition = 1e-3;
constexpr double kAdditionalTime = 10;  // [s] after which a repeated step is considered to be waiting
constexpr int kPollEvery = 500;         // control periods

using SwitchCounts = std::array<int, kOutputs>;  ///< number of times each output has switched on

/// State at the beginning or end of a top-level step, or of one iteration of a top-level endless loop.
struct Boundary {
    double time = 0;
    ControllerState state;
    SwitchCounts switches{};
    JointPositions q;
    bool isStandstill = false;
    std::map<QString, QString> variables;
    std::size_t order = 0;  ///< number of steps begun
};

/// State at the beginning of a step in a group.
struct Snapshot {
    ControllerState state;
    SwitchCounts switches{};
    JointPositions q;
    bool isStandstill = false;
    std::map<QString, QString> variables;
};

/// A step at the top level of the program, with the steps that must follow it, e.g. if and else.
struct Group {
    int first = 0;  ///< step numbers
    int last = 0;
    QUuid step;
    int iterationStep = 0;         ///< first step in an endless loop; 0: not an endless loop
    bool isIterationCall = false;  ///< `iterationStep` marks its beginning and its end
    bool isScript = false;         ///< contains URScript text, whose variables are unknown
    bool isRelative = false;       ///< the steps depend on the exact arm position
    QSet<QString> variables;       ///< variables that the steps set
    JointPositions start;          ///< [rad]
    std::vector<Boundary> boundaries;
    std::map<std::size_t, Snapshot> snapshots;  ///< up to the second boundary, by number of steps begun

    bool contains(int number) const { return number >= first && number <= last; }
};

/// A stop. The state is that after the control period in which the stop takes effect.
struct Moment {
    double time = 0;
    int step = 0;
    int mainStep = 0;  ///< step in the main program
    std::size_t group = 0;
    std::size_t segment = 0;  ///< index of the boundary before the stop
    ControllerState state;
    SwitchCounts switches{};
    JointPositions q;
    bool isStandstill = false;
    std::vector<InputChange> inputs;
};

/// Result of running a group again.
struct Repetition {
    enum class End { Reached, Waits, Fails, Cancelled };
    End end = End::Reached;
    int step = 0;  ///< step at the end
    Boundary boundary;
    std::vector<int> order;
};

/// A repetition with the state and the inputs at its start.
struct KnownRepetition {
    ControllerState state;
    std::vector<InputChange> inputs;
    Repetition result;
};

bool isSameInputs(const std::vector<InputChange>& a, const std::vector<InputChange>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const InputChange& x, const InputChange& y) {
        return x.time == y.time && x.channel == y.channel && x.value == y.value;
    });
}

/// Counts the outputs that switch on.
class SwitchCounter {
public:
    explicit SwitchCounter(std::uint64_t outputs) : last_(outputs) {}
    void add(std::uint64_t outputs) {
        for (std::uint64_t on = outputs & ~last_; on != 0; on &= on - 1) {
            const auto channel = static_cast<std::size_t>(std::countr_zero(on));
            if (channel < counts_.size()) {
                ++counts_[channel];
            }
        }
        last_ = outputs;
    }
    const SwitchCounts& counts() const { return counts_; }

private:
    std::uint64_t last_;
    SwitchCounts counts_{};
};

class Checker {
public:
    Checker(const project::Project& project, const QUuid& program, const ProgramScript& script,
            const ScriptOptions& scriptOptions, const RecoveryOptions& options)
        : project_(project)
        , program_(*project.programs.find(program))
        , script_(script)
        , scriptOptions_(scriptOptions)
        , options_(options) {
        options_.preview.answers = {};  // a repetition would need the answers from its first question on
        findSteps();
        findGroups();
        hasConstantInputs_ = std::all_of(options.preview.inputs.begin(), options.preview.inputs.end(),
                                         [](const InputChange& change) { return change.time <= 0; });
    }

    RecoveryMap check() {
        result_.steps.resize(script_.steps.size());
        record();
        for (const Moment& moment : moments_) {
            if (isCancelled_) {
                return std::move(result_);
            }
            StopPoint point;
            point.time = moment.time;
            point.step = moment.step;
            for (const StopKind kind : {StopKind::Protective, StopKind::Operator, StopKind::PowerLoss}) {
                mark(point, kind) = markOf(moment, kind);
            }
            result_.points.push_back(std::move(point));
        }
        markLinkLoss();
        markSteps();
        result_.isComplete = !isCancelled_;
        return std::move(result_);
    }

private:
    static StopMark& mark(StopPoint& point, StopKind kind) {
        return point.marks[static_cast<std::size_t>(kind)];
    }

    // ---- the program ------------------------------------------------------------------------------------

    void findSteps() {
        steps_.resize(script_.steps.size());
        parents_.resize(script_.steps.size());
        for (std::size_t at = 0; at < script_.steps.size();) {
            const QUuid owner = script_.steps[at].program;
            addSteps(project_.programs.find(owner)->steps, 0, at);
        }
    }
    void addSteps(const Steps& steps, int parent, std::size_t& at) {
        for (const ProgramStep& step : steps) {
            steps_[at] = &step;
            parents_[at] = parent;
            ++at;
            addSteps(step.steps, static_cast<int>(at), at);
        }
    }
    const ProgramStep& stepOf(int number) const { return *steps_[static_cast<std::size_t>(number - 1)]; }

    static bool isEnabled(const ProgramStep& step) {
        return !step.disabled && step.kind != QLatin1String("comment") && findStepKind(step.kind) != nullptr;
    }

    void findGroups() {
        for (const ProgramStep& step : program_.steps) {
            const int number = script_.numberOf(step.id);
            mainSteps_ = number + countOf(step.steps);
            if (!isEnabled(step)) {
                continue;
            }
            if (!findStepKind(step.kind)->follows.empty() && !groups_.empty()) {
                groups_.back().last = mainSteps_;
            } else {
                Group group;
                group.first = number;
                group.last = mainSteps_;
                group.step = step.id;
                if (step.kind == QLatin1String("loop") &&
                    step.fields.value(QLatin1String("times")).toInt(-1) == 0) {
                    const auto first = std::find_if(step.steps.begin(), step.steps.end(), isEnabled);
                    group.iterationStep = first == step.steps.end() ? 0 : script_.numberOf(first->id);
                    group.isIterationCall = group.iterationStep > 0 && first->kind == QLatin1String("call");
                }
                groups_.push_back(std::move(group));
            }
            addEffects({step}, 0, groups_.back());
        }
        group_ = groups_.size();
        repetitions_.resize(groups_.size());
        rests_.resize(groups_.size());
    }

    static int countOf(const Steps& steps) {
        int count = 0;
        for (const ProgramStep& step : steps) {
            count += 1 + countOf(step.steps);
        }
        return count;
    }

    void addEffects(const Steps& steps, int depth, Group& group) {
        constexpr int kMaxDepth = 20;
        for (const ProgramStep& step : steps) {
            const StepKind* kind = findStepKind(step.kind);
            if (step.disabled || kind == nullptr || depth > kMaxDepth) {
                continue;
            }
            group.isScript = group.isScript || step.kind == QLatin1String("script");
            group.isRelative = group.isRelative || kind->partlyDone != nullptr;
            for (const StepField& field : kind->fields()) {
                const QString value = fieldValue(step, field).toString();
                if (field.type == FieldType::Variable && !value.isEmpty()) {
                    group.variables.insert(value);
                } else if (field.type == FieldType::Program) {
                    if (const auto* called = project_.programs.find(QUuid(value))) {
                        addEffects(called->steps, depth + 1, group);
                    }
                } else if (field.type == FieldType::DigitalOutput && step.kind == QLatin1String("gripper") &&
                           field.key == QLatin1String("closeOutput")) {
                    gripperOutputs_.insert(fieldValue(step, field).toInt());
                }
            }
            addEffects(step.steps, depth, group);
        }
    }

    // ---- the uninterrupted run ----------------------------------------------------------------------------

    bool isCancelled() {
        if (options_.preview.isCancelled && ++periods_ % kPollEvery == 0 && options_.preview.isCancelled()) {
            isCancelled_ = true;
        }
        return isCancelled_;
    }

    static std::map<QString, QString> valuesOf(const SimulatedRun& run, const QSet<QString>& variables) {
        std::map<QString, QString> values;
        for (const QString& name : variables) {
            if (const auto value = run.controller().variable(name)) {
                values.emplace(name, *value);
            }
        }
        return values;
    }

    /// before  state before the control period
    static Snapshot snapshotOf(const SimulatedRun& run, const SwitchCounts& switches,
                               const JointPositions& before, bool wasStandstill,
                               const QSet<QString>& variables) {
        return {run.controller().controllerState(), switches, before, wasStandstill,
                valuesOf(run, variables)};
    }

    /// True if the rest of the group runs identically from both snapshots.
    bool isSame(const Snapshot& a, const Snapshot& b) const {
        return hasConstantInputs_ && a.state == b.state && a.variables == b.variables &&
               a.isStandstill == b.isStandstill &&
               (a.q.values - b.q.values).cwiseAbs().maxCoeff() < kSamePosition;
    }

    static Boundary boundaryOf(const SimulatedRun& run, const SwitchCounts& switches, std::size_t order,
                               const QSet<QString>& variables) {
        Boundary boundary;
        boundary.time = run.time();
        boundary.state = run.controller().controllerState();
        boundary.switches = switches;
        boundary.q = run.controller().q();
        boundary.isStandstill = run.controller().isStandstill();
        boundary.order = order;
        boundary.variables = valuesOf(run, variables);
        return boundary;
    }

    void record() {
        SimulatedRun run(project_, script_, scriptOptions_, options_.preview);
        installation_ = run.controller().controllerState();
        if (run.start()) {
            return;
        }
        SwitchCounter counter(installation_.digitalOutputs);
        Boundary before = boundaryOf(run, counter.counts(), 0, {});
        bool runs = true;
        while (runs && !isCancelled() && run.time() <= options_.preview.timeLimit) {
            runs = run.step();
            counter.add(run.controller().digitalOutputs());
            const bool wasMarked = followMarks(run, counter.counts(), before);
            if (isOver_) {
                return;
            }
            if (group_ < groups_.size() && wasMarked && groups_[group_].boundaries.size() == 1) {
                Group& group = groups_[group_];
                group.snapshots[order_.size() - group.boundaries.front().order] =
                    snapshotOf(run, counter.counts(), before.q, before.isStandstill, group.variables);
            }
            const bool isDue =
                !moments_.empty() && run.time() >= moments_.back().time + options_.interval - 1e-6;
            if (group_ < groups_.size() && runs && (wasMarked || isDue)) {
                addMoment(run, counter.counts(), before, wasMarked);
            }
            before = boundaryOf(run, counter.counts(), order_.size(), {});
        }
        const bool hasFailed = run.controller().failure().has_value() ||
                               run.controller().safetyMode() != SafetyMode::Normal || failed_;
        if (!runs && !hasFailed) {
            closeGroup(run, counter.counts());
        }
    }

    /// before  state before the control period
    bool followMarks(SimulatedRun& run, const SwitchCounts& switches, const Boundary& before) {
        bool wasMarked = false;
        for (const std::int32_t value : run.controller().takeWritten()) {
            failed_ = failed_ || value < 0;
            const bool isMain = value > 0 && value <= mainSteps_;
            if (value == 0 || (isMain && group_ < groups_.size() && !groups_[group_].contains(value))) {
                closeGroup(run, switches);
            }
            if (value <= 0 || value > static_cast<int>(script_.steps.size())) {
                continue;
            }
            if (isMain) {
                mainStep_ = value;
                if (group_ == groups_.size()) {
                    openGroup(value, before);
                } else if (isIteration(groups_[group_], value, iterationMarks_) &&
                           groups_[group_].boundaries.size() <= kCheckedIterations) {
                    Group& group = groups_[group_];
                    group.boundaries.push_back(boundaryOf(run, switches, order_.size(), group.variables));
                    isOver_ = group.boundaries.size() == kCheckedIterations + 1;
                }
            }
            step_ = value;
            order_.push_back(value);
            begun_.emplace_back(value, moments_.size());
            wasMarked = true;
        }
        return wasMarked;
    }

    /// True if the step begins the second or a later iteration of the endless loop.
    static bool isIteration(const Group& group, int step, int& marks) {
        if (group.iterationStep == 0 || step != group.iterationStep) {
            return false;
        }
        ++marks;
        const int iteration = group.isIterationCall ? (marks + 1) / 2 : marks;
        const bool begins = !group.isIterationCall || marks % 2 == 1;
        return begins && iteration > 1;
    }

    void openGroup(int step, const Boundary& before) {
        for (group_ = 0; group_ < groups_.size() && !groups_[group_].contains(step);) {
            ++group_;
        }
        if (group_ < groups_.size()) {
            Group& group = groups_[group_];
            Boundary begin = before;
            begin.order = order_.size();
            group.start = before.q;
            group.boundaries = {begin};
            iterationMarks_ = 0;
        }
    }

    void closeGroup(const SimulatedRun& run, const SwitchCounts& switches) {
        if (group_ < groups_.size()) {
            Group& group = groups_[group_];
            group.boundaries.push_back(boundaryOf(run, switches, order_.size(), group.variables));
            group_ = groups_.size();
        }
    }

    void addMoment(const SimulatedRun& run, const SwitchCounts& switches, const Boundary& before,
                   bool isBegin) {
        Moment moment;
        moment.time = run.time();
        moment.step = step_;
        moment.mainStep = mainStep_;
        moment.group = group_;
        moment.segment = groups_[group_].boundaries.size() - 1;
        moment.state = run.controller().controllerState();
        moment.switches = switches;
        moment.q = isBegin ? before.q : run.controller().q();
        moment.isStandstill = isBegin ? before.isStandstill : run.controller().isStandstill();
        moment.inputs = run.inputs();
        const std::vector<InputChange> later = run.remainingInputs();
        moment.inputs.insert(moment.inputs.end(), later.begin(), later.end());
        moments_.push_back(std::move(moment));
    }

    // ---- running a group again --------------------------------------------------------------------------

    struct Rest {
        ProgramScript script;
        std::vector<int> numbers;  ///< number of each step in the complete script
    };
    const Rest& restOf(std::size_t group) {
        std::optional<Rest>& rest = rests_[group];
        if (!rest) {
            ScriptOptions options = scriptOptions_;
            options.from = groups_[group].step;
            rest.emplace();
            rest->script = writeScript(project_, program_.id, options);
            std::map<std::pair<QUuid, QUuid>, int> numbers;
            for (std::size_t i = 0; i < script_.steps.size(); ++i) {
                numbers[{script_.steps[i].program, script_.steps[i].step}] = static_cast<int>(i) + 1;
            }
            for (const NumberedStep& step : rest->script.steps) {
                rest->numbers.push_back(numbers[{step.program, step.step}]);
            }
        }
        return *rest;
    }

    const Repetition& repeat(std::size_t index, const ControllerState& state,
                             const std::vector<InputChange>& inputs, double timeLimit) {
        std::vector<KnownRepetition>& known = repetitions_[index];
        const auto found = std::find_if(known.begin(), known.end(), [&](const KnownRepetition& each) {
            return each.state == state && isSameInputs(each.inputs, inputs);
        });
        if (found != known.end()) {
            return found->result;
        }
        known.push_back({state, inputs, run(index, state, inputs, timeLimit)});
        return known.back().result;
    }

    Repetition run(std::size_t index, const ControllerState& state, const std::vector<InputChange>& inputs,
                   double timeLimit) {
        const Group& group = groups_[index];
        const Rest& rest = restOf(index);
        PreviewOptions options = options_.preview;
        options.start = group.start;
        options.inputs = inputs;
        SimulatedRun run(project_, rest.script, scriptOptions_, options);
        run.controller().setControllerState(state);
        Repetition result;
        if (run.start()) {
            result.end = Repetition::End::Fails;
            return result;
        }
        SwitchCounter counter(state.digitalOutputs);
        int marks = 0;
        bool isReached = false;
        bool hasFailed = false;
        bool runs = true;
        const std::size_t firstOrder = group.boundaries.front().order;
        // A section restores the TCP that was set before it.
        bool isSameOrder =
            group.boundaries.size() > 1 && !group.isScript && state.tcp == group.boundaries.front().state.tcp;
        JointPositions before = run.controller().q();
        bool wasStandstill = true;
        while (runs && !isReached) {
            if (isCancelled()) {
                result.end = Repetition::End::Cancelled;
                return result;
            }
            if (run.time() > timeLimit) {
                result.end = Repetition::End::Waits;
                return result;
            }
            runs = run.step();
            counter.add(run.controller().digitalOutputs());
            bool wasMarked = false;
            for (const std::int32_t value : run.controller().takeWritten()) {
                hasFailed = hasFailed || value < 0;
                const bool isStep = value > 0 && value <= static_cast<int>(rest.numbers.size());
                const int number = isStep ? rest.numbers[static_cast<std::size_t>(value - 1)] : value;
                const bool isMain = number > 0 && number <= mainSteps_;
                isReached = isReached || number == 0 || (isMain && !group.contains(number)) ||
                            (isMain && isIteration(group, number, marks));
                if (!isReached && isStep) {
                    result.step = number;
                    isSameOrder = isSameOrder && firstOrder + result.order.size() < order_.size() &&
                                  order_[firstOrder + result.order.size()] == number;
                    result.order.push_back(number);
                    wasMarked = true;
                }
            }
            const auto snapshot = wasMarked && isSameOrder && !isReached && !hasFailed && runs
                                      ? group.snapshots.find(result.order.size())
                                      : group.snapshots.end();
            if (snapshot != group.snapshots.end() &&
                isSame(snapshot->second,
                       snapshotOf(run, counter.counts(), before, wasStandstill, group.variables))) {
                finishAs(group, snapshot->second, counter.counts(), result);
                return result;
            }
            before = run.controller().q();
            wasStandstill = run.controller().isStandstill();
        }
        if (hasFailed || run.controller().failure() || run.controller().safetyMode() != SafetyMode::Normal) {
            result.end = Repetition::End::Fails;
            return result;
        }
        result.boundary = boundaryOf(run, counter.counts(), result.order.size(), group.variables);
        return result;
    }

    /// Completes the result of a repetition whose state equals a state of the uninterrupted run. From there,
    /// both runs are identical.
    void finishAs(const Group& group, const Snapshot& reached, const SwitchCounts& switches,
                  Repetition& result) const {
        const Boundary& begin = group.boundaries[0];
        result.boundary = group.boundaries[1];
        for (std::size_t i = 0; i < switches.size(); ++i) {
            result.boundary.switches[i] += switches[i] - reached.switches[i];
        }
        result.order.assign(order_.begin() + static_cast<std::ptrdiff_t>(begin.order),
                            order_.begin() + static_cast<std::ptrdiff_t>(result.boundary.order));
    }

    // ---- marks ------------------------------------------------------------------------------------------

    QString nameOf(int step) const { return stepName(project_, script_, step); }

    /// Why the kinds of the steps that contain the stop prevent recovery; empty if they do not.
    QString kindReason(const Moment& moment) const {
        for (const int inner : {moment.step, moment.mainStep}) {
            for (int at = inner; at > 0; at = parents_[static_cast<std::size_t>(at - 1)]) {
                const StepKind* kind = findStepKind(stepOf(at).kind);
                if (kind != nullptr && kind->cannotContinue != nullptr) {
                    return kind->cannotContinue();
                }
            }
        }
        return {};
    }

    StopMark markOf(const Moment& moment, StopKind stop) {
        const Group& group = groups_[moment.group];
        const ProgramScript& rest = restOf(moment.group).script;
        if (!rest.ok()) {
            return {Recovery::Unsafe, rest.problems.empty() ? QString() : rest.problems.front().text};
        }
        if (const QString reason = kindReason(moment); !reason.isEmpty()) {
            return {Recovery::Unsafe, reason};
        }
        if (moment.segment + 1 >= group.boundaries.size()) {
            return {Recovery::Unsafe, ProgramText::tr("The simulated program does not complete step %1 (%2).")
                                          .arg(group.first)
                                          .arg(nameOf(group.first))};
        }
        const Boundary& begin = group.boundaries[moment.segment];
        const Boundary& end = group.boundaries[moment.segment + 1];
        const ControllerState& state = stop == StopKind::PowerLoss ? installation_ : moment.state;
        // The group needs an output that was on before the group, even if the next group switches the output
        // off.
        const std::uint64_t lost =
            begin.state.digitalOutputs & moment.state.digitalOutputs & ~state.digitalOutputs;
        if (lost != 0) {
            return {Recovery::Unsafe, outputReason(std::countr_zero(lost), false)};
        }
        const Repetition& again =
            repeat(moment.group, state, moment.inputs, 2 * (end.time - begin.time) + kAdditionalTime);
        if (const QString reason = difference(moment, begin, end, again); !reason.isEmpty()) {
            return {Recovery::Unsafe, reason};
        }
        // Brakes and a power failure displace the arm slightly.
        const bool isDisplaced = stop != StopKind::Operator && group.isRelative;
        if (moment.isStandstill && !isDisplaced &&
            (moment.q.values - group.start.values).cwiseAbs().maxCoeff() < kAtStartPosition) {
            return {Recovery::Continue, {}};
        }
        const StepKind* kind = findStepKind(stepOf(moment.step).kind);
        return {Recovery::MoveBack,
                kind != nullptr && kind->partlyDone != nullptr
                    ? kind->partlyDone()
                    : ProgramText::tr("The arm has left the start position of step %1 (%2).")
                          .arg(group.first)
                          .arg(nameOf(group.first))};
    }

    QString outputReason(int channel, bool repeats) const {
        const QString name = channelName(channel, true);
        if (gripperOutputs_.contains(channel)) {
            return repeats
                       ? ProgramText::tr("The gripper may hold a part and would close again (%1).").arg(name)
                       : ProgramText::tr("The gripper may have lost a part (%1).").arg(name);
        }
        return repeats ? ProgramText::tr("%1 would turn on again.").arg(name)
                       : ProgramText::tr("%1 would have a different value.").arg(name);
    }

    /// The first difference between the uninterrupted run and a stop followed by the repetition, as a
    /// sentence.
    QString difference(const Moment& moment, const Boundary& begin, const Boundary& end,
                       const Repetition& again) const {
        switch (again.end) {
            case Repetition::End::Waits:
                return ProgramText::tr("The program would wait in step %1 (%2).")
                    .arg(again.step)
                    .arg(nameOf(again.step));
            case Repetition::End::Fails:
                return ProgramText::tr("The program would fail in step %1 (%2).")
                    .arg(again.step)
                    .arg(nameOf(again.step));
            case Repetition::End::Cancelled:
                return ProgramText::tr("The check was cancelled.");
            case Repetition::End::Reached:
                break;
        }
        const ControllerState& state = again.boundary.state;
        for (int channel = 0; channel < kOutputs; ++channel) {
            if (((state.digitalOutputs ^ end.state.digitalOutputs) >> channel & 1U) != 0) {
                return outputReason(channel, false);
            }
        }
        for (std::size_t i = 0; i < kOutputs; ++i) {
            if (moment.switches[i] - begin.switches[i] + again.boundary.switches[i] !=
                end.switches[i] - begin.switches[i]) {
                return outputReason(static_cast<int>(i), true);
            }
        }
        if (state.analogOutputs != end.state.analogOutputs) {
            return ProgramText::tr("An analog output would have a different value.");
        }
        if (state.boolRegisters != end.state.boolRegisters ||
            state.integerRegisters != end.state.integerRegisters ||
            state.floatRegisters != end.state.floatRegisters) {
            return ProgramText::tr("A register would have a different value.");
        }
        for (const auto& [name, value] : end.variables) {
            const auto found = again.boundary.variables.find(name);
            if (found == again.boundary.variables.end() || found->second != value) {
                return ProgramText::tr("The variable “%1” would have a different value.").arg(name);
            }
        }
        if (!(state.tcp.transform().isApprox(end.state.tcp.transform(), 1e-6)) ||
            state.payload != end.state.payload || state.payloadCentre != end.state.payloadCentre) {
            return ProgramText::tr("The TCP or the payload would differ.");
        }
        if (!isSameOrder(begin, end, again.order)) {
            return ProgramText::tr("The program would run different steps.");
        }
        if (end.isStandstill &&
            (again.boundary.q.values - end.q.values).cwiseAbs().maxCoeff() > kSamePosition) {
            return ProgramText::tr("The arm would end at a different position.");
        }
        return {};
    }

    /// Compares the steps of a repetition with those of the uninterrupted run. Later iterations of an endless
    /// loop do not contain the loop step itself.
    bool isSameOrder(const Boundary& begin, const Boundary& end, const std::vector<int>& again) const {
        const auto first = order_.begin() + static_cast<std::ptrdiff_t>(begin.order);
        const auto last = order_.begin() + static_cast<std::ptrdiff_t>(end.order);
        const bool isLater = first != last && !again.empty() && *first != again.front();
        return std::equal(first, last, again.begin() + (isLater ? 1 : 0), again.end());
    }

    void markLinkLoss() {
        for (StopPoint& point : result_.points) {
            StopMark& worst = mark(point, StopKind::LinkLoss);
            for (auto later = result_.points.begin() + (&point - result_.points.data());
                 later != result_.points.end() && later->time <= point.time + kMaxLinkLossTime; ++later) {
                takeWorse(worst, mark(*later, StopKind::Operator));
            }
        }
    }

    static void takeWorse(StopMark& worst, const StopMark& other) {
        if (other.recovery > worst.recovery) {
            worst = other;
        }
    }

    void markSteps() {
        const auto add = [&](int step, std::size_t at) {
            StepRecovery& recovery = result_.steps[static_cast<std::size_t>(step - 1)];
            for (std::size_t kind = 0; kind < kStopKinds.size(); ++kind) {
                takeWorse(recovery.marks[kind], result_.points[at].marks[kind]);
            }
            const Group& group = groups_[moments_[at].group];
            recovery.from = group.first;
            recovery.fromStep = group.step;
            recovery.start = group.start;
        };
        for (std::size_t i = 0; i < moments_.size(); ++i) {
            add(moments_[i].step, i);
        }
        // Steps that take no time cannot be interrupted. The stop takes effect in the next step that takes
        // time.
        for (const auto& [step, at] : begun_) {
            if (at < moments_.size() && moments_[at].step != step &&
                result_.steps[static_cast<std::size_t>(step - 1)].from == 0) {
                add(step, at);
            }
        }
    }

    const project::Project& project_;
    const project::Program& program_;
    const ProgramScript& script_;
    const ScriptOptions& scriptOptions_;
    RecoveryOptions options_;
    std::vector<const ProgramStep*> steps_;  ///< steps by number
    std::vector<int> parents_;               ///< number of the enclosing section; 0: none
    int mainSteps_ = 0;                      ///< steps up to this number belong to the main program
    std::vector<Group> groups_;
    QSet<int> gripperOutputs_;
    std::vector<std::optional<Rest>> rests_;
    std::vector<std::vector<KnownRepetition>> repetitions_;

    bool hasConstantInputs_ = true;
    ControllerState installation_;  ///< state of a started controller
    std::size_t group_ = 0;         ///< the running group; groups_.size(): none
    int mainStep_ = 0;
    int step_ = 0;
    int iterationMarks_ = 0;
    bool isOver_ = false;
    bool failed_ = false;
    std::vector<int> order_;
    std::vector<std::pair<int, std::size_t>> begun_;  ///< step numbers, with the index of the next stop
    std::vector<Moment> moments_;
    int periods_ = 0;
    bool isCancelled_ = false;
    RecoveryMap result_;
};

}  // namespace

RecoveryMap checkRecovery(const project::Project& project, const QUuid& program, const ProgramScript& script,
                          const ScriptOptions& scriptOptions, const RecoveryOptions& options) {
    if (!script.ok() || project.programs.find(program) == nullptr) {
        return {};
    }
    return Checker(project, program, script, scriptOptions, options).check();
}

namespace {

Recovery worstWithPower(const StepRecovery& recovery) {
    return std::max({recovery.of(StopKind::Protective).recovery, recovery.of(StopKind::Operator).recovery,
                     recovery.of(StopKind::LinkLoss).recovery});
}

}  // namespace

QString recoveryMark(const StepRecovery& recovery) {
    const Recovery worst = worstWithPower(recovery);
    switch (worst) {
        case Recovery::NotReached:
            break;
        case Recovery::Continue:
            return ProgramText::tr("✔ Continue");
        case Recovery::MoveBack:
            return ProgramText::tr("↩ Move back");
        case Recovery::Unsafe:
            return ProgramText::tr("✖ Unsafe");
    }
    return {};
}

QString recoveryDetails(const StepRecovery& recovery) {
    QStringList lines{ProgramText::tr("Simulated, after a stop in this step:")};
    for (const StopKind kind : kStopKinds) {
        const StopMark& mark = recovery.of(kind);
        lines.append(mark.reason.isEmpty()
                         ? QStringLiteral("%1: %2").arg(stopKindText(kind), recoveryText(mark.recovery))
                         : QStringLiteral("%1: %2. %3")
                               .arg(stopKindText(kind), recoveryText(mark.recovery), mark.reason));
    }
    return lines.join(QLatin1Char('\n'));
}

RecoveryCount countRecoverable(const RecoveryMap& map) {
    RecoveryCount count;
    for (const StepRecovery& recovery : map.steps) {
        if (recovery.from > 0) {
            ++count.steps;
            count.recoverable += worstWithPower(recovery) == Recovery::Unsafe ? 0 : 1;
        }
    }
    return count;
}

QString recoveryText(Recovery recovery) {
    switch (recovery) {
        case Recovery::NotReached:
            return ProgramText::tr("not reached");
        case Recovery::Continue:
            return ProgramText::tr("can continue");
        case Recovery::MoveBack:
            return ProgramText::tr("can continue after moving back");
        case Recovery::Unsafe:
            return ProgramText::tr("cannot continue safely");
    }
    return {};
}

QString stopKindText(StopKind kind) {
    switch (kind) {
        case StopKind::Protective:
            return ProgramText::tr("Protective stop");
        case StopKind::Operator:
            return ProgramText::tr("Stop by the operator");
        case StopKind::LinkLoss:
            return ProgramText::tr("Connection loss");
        case StopKind::PowerLoss:
            return ProgramText::tr("Power loss");
    }
    return {};
}

}  // namespace tiller::program
