// SPDX-License-Identifier: MIT
#include "robot/station/program/preview/preview.h"

#include <QLocale>
#include <algorithm>
#include <set>

#include "robot/collision/collision_check.h"
#include "robot/project/reachability.h"
#include "robot/simulator/script_run.h"
#include "robot/simulator/simulator_options.h"
#include "robot/station/document/cell_surroundings.h"
#include "robot/station/program/program_edit.h"
#include "robot/station/program/program_text.h"

namespace tiller::program {
namespace {

constexpr int kCancelEvery = 500;  ///< number of control periods

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

/// One simulated run of a script, observed step by step.
class Follower {
public:
    Follower(const project::Project& project, const ProgramScript& script, const ScriptOptions& scriptOptions,
             const PreviewOptions& options)
        : script_(script)
        , options_(options)
        , cell_(surroundingsOf(project))
        , tcp_(tcpAtStart(project, script))
        , check_(robotModel(modelFor(project, scriptOptions)), {tcp_, cell_.toolRadius}, cell_.around,
                 cell_.safetyDistance)
        , run_(runOptions(project, script, scriptOptions, options))
        , inputs_(options.inputs) {
        std::stable_sort(inputs_.begin(), inputs_.end(),
                         [](const InputChange& a, const InputChange& b) { return a.time < b.time; });
    }

    Preview follow() {
        result_.timings.resize(script_.steps.size());
        for (const collision::UnplacedObject& object : cell_.unplaced) {
            find(
                Finding::Kind::Collision, 0,
                ProgramText::tr("The position of “%1” is unknown because its frame %2 is not in the project.")
                    .arg(object.name, object.frame));
        }
        applyInputs();
        if (const auto fault = run_.start(script_.text)) {
            find(Finding::Kind::ScriptError, script_.stepAt(fault->line), fault->text);
            return std::move(result_);
        }
        sample();
        while (run_.step() && !isOver()) {
            followMarks();
            applyInputs();
            answerOperator();
            if (run_.time() >= nextSample_) {
                sample();
            }
        }
        followMarks();
        finish();
        return std::move(result_);
    }

private:
    static Pose tcpAtStart(const project::Project& project, const ProgramScript& script) {
        const project::Tool* active = project.tooling.tools.find(project.tooling.activeTool);
        return active != nullptr ? active->tcpOffset : script.tcp.value_or(Pose());
    }

    static simulator::ScriptRunOptions runOptions(const project::Project& project,
                                                  const ProgramScript& script,
                                                  const ScriptOptions& scriptOptions,
                                                  const PreviewOptions& options) {
        simulator::ScriptRunOptions run;
        run.model = modelFor(project, scriptOptions);
        run.software = scriptOptions.version;
        run.start = options.start.value_or(startPosition(project, script));
        run.tcp = tcpAtStart(project, script);
        run.followedRegister = kStepRegister;
        return run;
    }

    void find(Finding::Kind kind, int step, const QString& text) {
        result_.findings.push_back({kind, step, run_.time(), text});
    }

    void followMarks() {
        for (const std::int32_t value : run_.takeWritten()) {
            const double now = run_.time();
            if (step_ > 0) {
                timing(step_).total += now - stepBegan_;
            }
            const bool known = value > 0 && value <= static_cast<int>(script_.steps.size());
            if (value < 0) {
                failed_ = true;
                find(Finding::Kind::StepFailed, -value,
                     ProgramText::tr("The step failed and ended the program."));
            }
            step_ = known ? value : 0;
            stepBegan_ = now;
            if (known) {
                followCycles();
                if (cycles_ > kPreviewCycles) {
                    step_ = 0;
                    return;
                }
                result_.order.push_back(step_);
                StepTiming& first = timing(step_);
                first.first = first.count++ == 0 ? now : first.first;
            }
        }
    }

    // The first step of a cycle starts once in each cycle. A section that starts with it can mark it twice; then fewer
    // cycles are run, but at least one.
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

    StepTiming& timing(int step) { return result_.timings[static_cast<std::size_t>(step - 1)]; }

    void applyInputs() {
        while (nextInput_ < inputs_.size() && inputs_[nextInput_].time <= run_.time()) {
            run_.setDigitalInput(inputs_[nextInput_].channel, inputs_[nextInput_].value);
            ++nextInput_;
        }
    }

    void answerOperator() {
        if (!run_.waitsForOperator()) {
            askedAt_.reset();
        } else if (!askedAt_) {
            askedAt_ = run_.time();
        } else if (run_.time() - *askedAt_ >= options_.operatorTime) {
            run_.answerOperator();
            askedAt_.reset();
        }
    }

    bool isOver() {
        if (cycles_ > kPreviewCycles) {
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

    /// Adds a sample to the path, and checks the segment since the previous sample for collisions.
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
        result_.path.push_back(now);
    }

    void finish() {
        sample();
        if (step_ > 0) {
            timing(step_).total += run_.time() - stepBegan_;
        }
        const auto failure = run_.failure();
        if (failure) {
            find(Finding::Kind::RuntimeError, script_.stepAt(failure->line), failure->text);
        }
        const bool stopped = run_.safetyMode() != SafetyMode::Normal;
        if (stopped) {
            find(Finding::Kind::ProtectiveStop, step_, run_.stopText());
        }
        const bool cut =
            std::any_of(result_.findings.begin(), result_.findings.end(), [](const Finding& finding) {
                return finding.kind == Finding::Kind::TimeLimit || finding.kind == Finding::Kind::Cancelled;
            });
        result_.completed = !failure && !stopped && !cut && !failed_;
        result_.duration = run_.time();
        result_.endJoints = run_.q();
        result_.endPose = run_.tcpPose();
        result_.outputs = run_.digitalOutputs();
    }

    const ProgramScript& script_;
    const PreviewOptions& options_;
    collision::CellSurroundings cell_;
    Pose tcp_;
    collision::CollisionCheck check_;
    simulator::ScriptRun run_;
    std::vector<InputChange> inputs_;
    std::size_t nextInput_ = 0;
    Preview result_;
    int step_ = 0;
    double stepBegan_ = 0;
    double nextSample_ = 0;
    std::optional<double> askedAt_;
    std::set<std::array<int, 3>> contactSteps_;  ///< each contact is reported once per step
    int steps_ = 0;
    bool failed_ = false;
    int cycle_ = 0;         ///< step number of the endless loop that runs; 0: none
    int firstOfCycle_ = 0;  ///< step number; 0: not known yet
    int cycles_ = 0;        ///< cycles that have begun
};

}  // namespace

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
