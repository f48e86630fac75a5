// SPDX-License-Identifier: MIT
#include "robot/station/program/preview/preview.h"

#include <QLocale>
#include <algorithm>
#include <bit>
#include <set>

#include "robot/control/motion_types.h"
#include "robot/project/reachability.h"
#include "robot/script/supervised_program.h"
#include "robot/simulator/options/simulator_options.h"
#include "robot/station/document/cell_surroundings.h"
#include "robot/station/program/preview/simulated_run.h"
#include "robot/station/program/program_edit.h"
#include "robot/station/program/program_text.h"
#include "robot/station/text/move_words.h"

namespace tiller::program {
namespace {

constexpr int kCancelEvery = 500;       ///< check for cancellation every n-th control period
constexpr int kHeartbeatRegister = 24;  ///< integer input; the first register used by a run from the PC
constexpr double kMaxStoppingTime = 2;  ///< maximum time from the stop of the program to standstill [s]

RobotModelId modelFor(const project::Project& project, const ScriptOptions& options) {
    return options.model.value_or(project.robot.value_or(RobotModelId::UR5e));
}

QString contactText(const collision::Contact& contact, const collision::Surroundings& around) {
    const auto index = static_cast<std::size_t>(contact.other);
    switch (contact.with) {
        case collision::Contact::With::Arm:
            return ProgramText::tr("The arm comes too close to itself.");
        case collision::Contact::With::Obstacle:
            return ProgramText::tr("The arm comes too close to “%1”.").arg(around.obstacles.at(index).name);
        case collision::Contact::With::Border:
            return around.borders.at(index).name.isEmpty()
                       ? ProgramText::tr("The arm comes too close to the floor.")
                       : ProgramText::tr("The arm comes too close to “%1”.")
                             .arg(around.borders.at(index).name);
    }
    return {};
}

/// A simulated run of a script, monitored step by step.
class Follower {
public:
    Follower(const project::Project& project, const ProgramScript& script, const ScriptOptions& scriptOptions,
             const PreviewOptions& options)
        : script_(script)
        , options_(options)
        , cell_(surroundingsOf(project))
        , check_(robotModel(modelFor(project, scriptOptions)),
                 {SimulatedRun::tcpAtStart(project, script), cell_.toolRadius}, cell_.around,
                 cell_.safetyDistance, options.known)
        , simulated_(project, script, scriptOptions, options)
        , text_(script::unsupervised(script.text)) {
        const std::vector<PreviewEvent>& events = options.events;
        for (std::size_t i = 0; i < events.size(); ++i) {
            if (events[i].step == 0) {
                // A stop before the start would have no effect on the program.
                const double earliest = isStop(events[i].kind) ? 1.5 * run_.stepTime() : 0;
                schedule(i, std::max(earliest, events[i].time));
            }
        }
        hasHeartbeat_ = std::any_of(events.begin(), events.end(), [](const PreviewEvent& event) {
            return event.kind == PreviewEvent::Kind::LinkLoss;
        });
        if (hasHeartbeat_) {
            script::Heartbeat heartbeat;
            heartbeat.number = kHeartbeatRegister;
            heartbeat.timeout = control::kHoldTime;
            text_ = script::supervised(script.text, heartbeat, scriptOptions.version);
        }
    }

    Preview follow() {
        result_.timings.resize(script_.steps.size());
        result_.startJoints.resize(script_.steps.size());
        for (const collision::UnplacedObject& object : cell_.unplaced) {
            find(Finding::Kind::Collision, 0, unplacedText(object) + QLatin1Char('.'));
        }
        applyEvents();
        outputs_ = run_.digitalOutputs();
        result_.analogOutputs = run_.analogOutputs();
        if (const auto fault = simulated_.start(text_.text)) {
            result_.endStep = script_.stepAt(text_.lineOf(fault->line));
            find(Finding::Kind::ScriptError, result_.endStep, fault->text);
            return std::move(result_);
        }
        sample();
        JointPositions before = run_.q();
        while (simulated_.step() && !isOver()) {
            followMarks(before);
            before = run_.q();
            followOutputs();
            followForce();
            applyEvents();
            sendHeartbeat();
            if (run_.time() >= nextSample_) {
                sample();
            }
        }
        followMarks(before);
        followOutputs();
        finish();
        return std::move(result_);
    }

private:
    void find(Finding::Kind kind, int step, const QString& text) {
        result_.findings.push_back({kind, step, run_.time(), text});
    }

    /// before  arm position before the last control period: the start position of the steps that began in it
    void followMarks(const JointPositions& before) {
        for (const std::int32_t value : run_.takeWritten()) {
            const double now = run_.time();
            if (step_ > 0) {
                timing(step_).total += now - stepBegan_;
            }
            const bool known = value > 0 && value <= static_cast<int>(script_.steps.size());
            lastMark_ = value;
            if (value < 0) {
                failed_ = true;
                result_.endStep = -value;
                find(Finding::Kind::StepFailed, -value,
                     ProgramText::tr("The step failed and ended the program."));
            }
            step_ = known ? value : 0;
            stepBegan_ = now;
            if (known) {
                followCycles();
                if (hasRunCycles()) {
                    step_ = 0;
                    return;
                }
                result_.order.push_back(step_);
                result_.starts.push_back(now);
                StepTiming& first = timing(step_);
                if (first.count++ == 0) {
                    first.first = now;
                    result_.startJoints[static_cast<std::size_t>(step_ - 1)] = before;
                }
                scheduleAtStep(first.count);
            }
        }
    }

    // The first step of a cycle starts once in each cycle. A section that starts with this step can mark it
    // twice. Then fewer cycles are run, but at least one.
    void followCycles() {
        if (std::find(script_.cycles.begin(), script_.cycles.end(), step_) != script_.cycles.end()) {
            cycle_ = step_;
            firstOfCycle_ = 0;
            cycles_ = 0;
        } else if (cycle_ > 0) {
            firstOfCycle_ = firstOfCycle_ == 0 ? step_ : firstOfCycle_;
            cycles_ += step_ == firstOfCycle_ ? 1 : 0;
        }
    }

    bool hasRunCycles() const { return options_.maxCycles > 0 && cycles_ > options_.maxCycles; }

    StepTiming& timing(int step) { return result_.timings[static_cast<std::size_t>(step - 1)]; }

    /// Adds an event after those with the same time.
    void schedule(std::size_t event, double due) {
        const auto later = std::upper_bound(due_.begin(), due_.end(), due,
                                            [](double time, const Due& other) { return time < other.time; });
        due_.insert(later, {due, event});
    }

    /// Schedules the events for the n-th beginning of the running step.
    void scheduleAtStep(int run) {
        for (std::size_t i = 0; i < options_.events.size(); ++i) {
            if (options_.events[i].step == step_ && options_.events[i].run == run) {
                schedule(i, run_.time() + options_.events[i].time);
            }
        }
    }

    void applyEvents() {
        while (!due_.empty() && due_.front().time <= run_.time()) {
            apply(options_.events[due_.front().event]);
            applied_.insert(due_.front().event);
            due_.erase(due_.begin());
        }
    }

    void apply(const PreviewEvent& event) {
        using Kind = PreviewEvent::Kind;
        isStopped_ = isStopped_ || isStop(event.kind);
        switch (event.kind) {
            case Kind::DigitalInput:
                run_.setDigitalInput(event.channel, event.value != 0);
                break;
            case Kind::AnalogInput:
                run_.setAnalogInput(event.channel, event.value);
                break;
            case Kind::HandForce:
                run_.setHandForce(event.force);
                break;
            case Kind::ProtectiveStop:
                run_.stop(simulator::StopEvent::ProtectiveStop);
                break;
            case Kind::OperatorStop:
                run_.stop(simulator::StopEvent::OperatorStop);
                break;
            case Kind::EmergencyStop:
                run_.stop(simulator::StopEvent::EmergencyStop);
                break;
            case Kind::PowerLoss:
                run_.stop(simulator::StopEvent::PowerLoss);
                break;
            case Kind::LinkLoss:
                hasHeartbeat_ = false;
                break;
        }
    }

    void sendHeartbeat() {
        if (hasHeartbeat_) {
            run_.setInputInteger(kHeartbeatRegister, ++heartbeat_);
        }
    }

    void followOutputs() {
        const std::uint64_t outputs = run_.digitalOutputs();
        for (std::uint64_t changed = outputs ^ outputs_; changed != 0; changed &= changed - 1) {
            const int channel = std::countr_zero(changed);
            result_.outputChanges.push_back(
                {run_.time(), channel, ((outputs >> channel) & 1U) != 0 ? 1.0 : 0.0});
        }
        outputs_ = outputs;
        const std::array<double, 2> analog = run_.analogOutputs();
        for (std::size_t i = 0; i < analog.size(); ++i) {
            if (analog[i] != result_.analogOutputs[i]) {
                result_.outputChanges.push_back(
                    {run_.time(), kFirstAnalogOutput + static_cast<int>(i), analog[i]});
            }
        }
        result_.analogOutputs = analog;
    }

    void followForce() {
        if (const double force = run_.tcpForce(); force > result_.force.value) {
            result_.force = {force, run_.time(), step_};
        }
    }

    bool isOver() {
        if (hasRunCycles()) {
            result_.isEndless = true;
            return true;
        }
        if (run_.time() > options_.timeLimit) {
            find(Finding::Kind::TimeLimit, step_,
                 ProgramText::tr("The program did not end within %1 s.").arg(options_.timeLimit));
            return true;
        }
        if (options_.isCancelled && ++steps_ % kCancelEvery == 0 && options_.isCancelled()) {
            find(Finding::Kind::Cancelled, step_, ProgramText::tr("The preview was cancelled."));
            return true;
        }
        return false;
    }

    /// Adds a sample to the path, and checks the segment from the previous sample for collisions.
    void sample() {
        nextSample_ = run_.time() + options_.sampleInterval;
        const PathSample now{run_.time(), step_, run_.q(), run_.tcpPose()};
        const auto contact = result_.path.empty()
                                 ? check_.at(now.q)
                                 : check_.obstruction(std::array{result_.path.back().q, now.q});
        if (contact &&
            contactSteps_.insert({step_, static_cast<int>(contact->with), contact->other}).second) {
            find(Finding::Kind::Collision, step_, contactText(*contact, cell_.around));
        }
        if (options_.measuresClearance) {
            measureClearance(now);
        }
        result_.path.push_back(now);
    }

    void measureClearance(const PathSample& now) {
        const collision::CollisionCheck::Placement placement = check_.place(now.q);
        for (const collision::CollisionCheck::Pair& pair : check_.pairs()) {
            if (pair.with != collision::Contact::With::Arm) {
                const double distance = check_.distance(pair, placement);
                if (!result_.clearance || distance < result_.clearance->value) {
                    result_.clearance = {distance, now.time, now.step};
                }
            }
        }
    }

    /// Runs until the arm is at standstill after a stop that ended the program at once.
    void awaitStandstill() {
        const double end = run_.time() + kMaxStoppingTime;
        while (!run_.isStandstill() && run_.time() < end) {
            run_.step();
        }
    }

    void finish() {
        sample();
        if (step_ > 0) {
            timing(step_).total += run_.time() - stepBegan_;
            result_.endStep = step_;
        }
        result_.duration = run_.time();
        const auto failure = run_.failure();
        if (failure) {
            const int step = script_.stepAt(text_.lineOf(failure->line));
            find(Finding::Kind::RuntimeError, step, failure->text);
            result_.endStep = step > 0 ? step : result_.endStep;
        }
        const bool hasSafetyStop = run_.safetyMode() != SafetyMode::Normal;
        if (hasSafetyStop && run_.safetyMode() != SafetyMode::RobotEmergencyStop) {
            find(Finding::Kind::ProtectiveStop, step_, run_.stopText());
        }
        // A program that has already written 0 to the step register, i.e. has reached its end, was not
        // affected by the stop.
        const bool stopped = hasSafetyStop || (isStopped_ && lastMark_ != 0);
        const bool cut =
            std::any_of(result_.findings.begin(), result_.findings.end(), [](const Finding& finding) {
                return finding.kind == Finding::Kind::TimeLimit || finding.kind == Finding::Kind::Cancelled;
            });
        result_.end = cut                  ? Preview::End::Running
                      : failure || failed_ ? Preview::End::Failed
                      : stopped            ? Preview::End::Stopped
                      : result_.isEndless  ? Preview::End::Running
                                           : Preview::End::Completed;
        result_.completed = result_.end == Preview::End::Completed ||
                            (result_.end == Preview::End::Running && result_.isEndless);
        if (stopped) {
            awaitStandstill();
        }
        result_.endJoints = run_.q();
        result_.endPose = run_.tcpPose();
        result_.outputs = run_.digitalOutputs();
        result_.questions = simulated_.questions();
        result_.unfitAnswers = simulated_.unfitAnswers();
        for (const std::string& name : options_.variables) {
            result_.variables[name] = run_.followedVariable(name);
        }
        for (std::size_t i = 0; i < options_.events.size(); ++i) {
            if (!applied_.contains(i)) {
                result_.unusedEvents.push_back(i);
            }
        }
    }

    const ProgramScript& script_;
    const PreviewOptions& options_;
    collision::CellSurroundings cell_;
    collision::CollisionCheck check_;
    SimulatedRun simulated_;
    simulator::ScriptRun& run_ = simulated_.controller();
    struct Due {
        double time = 0;
        std::size_t event = 0;  ///< index into PreviewOptions::events
    };
    std::vector<Due> due_;  ///< scheduled, in the order of their times
    std::set<std::size_t> applied_;
    script::SupervisedProgram text_;
    Preview result_;
    std::optional<std::int32_t> lastMark_;  ///< last value of the step register
    bool isStopped_ = false;                ///< stopped by an event
    bool hasHeartbeat_ = false;
    std::int32_t heartbeat_ = 0;
    std::uint64_t outputs_ = 0;
    int step_ = 0;
    double stepBegan_ = 0;
    double nextSample_ = 0;
    std::set<std::array<int, 3>> contactSteps_;  ///< each contact is reported once per step
    int steps_ = 0;
    bool failed_ = false;
    int cycle_ = 0;         ///< step number of the running endless loop; 0: none
    int firstOfCycle_ = 0;  ///< step number; 0: not known yet
    int cycles_ = 0;        ///< cycles that have begun
};

}  // namespace

bool isStop(PreviewEvent::Kind kind) {
    using Kind = PreviewEvent::Kind;
    return kind != Kind::DigitalInput && kind != Kind::AnalogInput && kind != Kind::HandForce;
}

QString findingText(const project::Project& project, const ProgramScript& script, const Finding& finding) {
    const QString time = QLocale().toString(finding.time, 'f', 1);
    const QString name = stepName(project, script, finding.step);
    return name.isEmpty()
               ? ProgramText::tr("At %1 s: %2").arg(time, finding.text)
               : ProgramText::tr("Step %1 (%2) at %3 s: %4").arg(finding.step).arg(name, time, finding.text);
}

std::vector<Eigen::Vector3d> tcpPath(const Preview& preview, double spacing) {
    std::vector<Eigen::Vector3d> places;
    for (const PathSample& sample : preview.path) {
        if (places.empty() || (sample.tcp.position - places.back()).norm() >= spacing) {
            places.push_back(sample.tcp.position);
        }
    }
    return places;
}

JointPositions startPosition(const project::Project& project, const ProgramScript& script) {
    for (const NumberedStep& numbered : script.steps) {
        const project::Program* owner = project.programs.find(numbered.program);
        const project::ProgramStep* step = owner != nullptr ? findStep(owner->steps, numbered.step) : nullptr;
        const int index =
            step != nullptr
                ? project.waypoints.indexOf(QUuid(step->fields.value(QLatin1String("waypoint")).toString()))
                : -1;
        if (index >= 0) {
            return project.waypoints.at(index).joints;
        }
    }
    const project::NamedPosition* home = project.positions.homePosition();
    return home != nullptr ? home->joints : simulator::kHomeJoints;
}

Preview previewProgram(const project::Project& project, const ProgramScript& script,
                       const ScriptOptions& scriptOptions, const PreviewOptions& options) {
    return Follower(project, script, scriptOptions, options).follow();
}

}  // namespace tiller::program
