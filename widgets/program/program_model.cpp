// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/program/program_model.h"

#include <QFont>
#include <QLocale>
#include <QMimeData>

#include "robot/station/program/step_kind.h"
#include "widgets/common/theme.h"

namespace tiller {

using project::ProgramStep;

namespace {

constexpr char kIdsMime[] = "application/x-tiller-step-ids";
constexpr int kColumns = 3;

}  // namespace

struct ProgramModel::Node {
    const ProgramStep* step = nullptr;  ///< points into the program of the model
    Node* parent = nullptr;
    int row = 0;
    int number = 0;
    std::vector<std::unique_ptr<Node>> children;
    QString problem;                 ///< reason why the program cannot run
    QString result;                  ///< result of the preview
    bool hasFinding = false;         ///< true if the preview has a finding for this step
    program::StepRecovery recovery;  ///< marks of the recoverability check

    bool isMarked() const { return !problem.isEmpty() || hasFinding; }
    bool isComment() const { return step->kind == QLatin1String("comment"); }
    bool isSection() const {
        const program::StepKind* kind = program::findStepKind(step->kind);
        return kind != nullptr && kind->isSection;
    }
};

namespace {

bool isSameTree(const std::vector<ProgramStep>& a, const std::vector<ProgramStep>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const ProgramStep& x, const ProgramStep& y) {
        return x.id == y.id && x.kind == y.kind && isSameTree(x.steps, y.steps);
    });
}

}  // namespace

ProgramModel::ProgramModel(QObject* parent) : QAbstractItemModel(parent), root_(std::make_unique<Node>()) {}
ProgramModel::~ProgramModel() = default;

void ProgramModel::setProgram(const project::Project& project, const project::Program* program) {
    project::Program next = program != nullptr ? *program : project::Program();
    const bool same = next.id == program_.id && isSameTree(next.steps, program_.steps);
    if (!same) {
        beginResetModel();
        root_ = std::make_unique<Node>();
        nodes_.clear();
    }
    project_ = &project;
    program_ = std::move(next);
    int number = 0;
    const std::function<void(Node&, const std::vector<ProgramStep>&)> fill =
        [&](Node& node, const std::vector<ProgramStep>& steps) {
            node.children.resize(steps.size());
            for (std::size_t i = 0; i < steps.size(); ++i) {
                if (!node.children[i]) {
                    node.children[i] = std::make_unique<Node>();
                }
                Node& child = *node.children[i];
                child.step = &steps[i];
                child.parent = &node;
                child.row = static_cast<int>(i);
                child.number = ++number;
                nodes_[steps[i].id] = &child;
                fill(child, steps[i].steps);
            }
        };
    fill(*root_, program_.steps);
    if (same) {
        changed();
        return;
    }
    endResetModel();
    Q_EMIT treeChanged();
}

void ProgramModel::changed() {
    const std::function<void(const Node&)> report = [&](const Node& node) {
        if (node.children.empty()) {
            return;
        }
        const Node& last = *node.children.back();
        Q_EMIT dataChanged(createIndex(0, 0, node.children.front().get()),
                           createIndex(last.row, kColumns - 1, &last));
        for (const auto& child : node.children) {
            report(*child);
        }
    };
    report(*root_);
}

void ProgramModel::setProblems(const std::vector<program::ProgramProblem>& problems) {
    for (Node* node : nodes_) {
        node->problem.clear();
    }
    for (const program::ProgramProblem& problem : problems) {
        if (Node* node = nodes_.value(problem.step);
            node != nullptr && problem.program == program_.id && node->problem.isEmpty()) {
            node->problem = problem.text;
        }
    }
    changed();
}

void ProgramModel::showTimings(const program::ProgramScript& script,
                               const std::vector<program::StepTiming>& timings) {
    for (std::size_t i = 0; i < std::min(script.steps.size(), timings.size()); ++i) {
        const program::StepTiming& timing = timings[i];
        Node* node = script.steps[i].program == program_.id ? nodes_.value(script.steps[i].step) : nullptr;
        if (node != nullptr && timing.count > 0) {
            node->result = tr("%1 × %2 s")
                               .arg(timing.count)
                               .arg(QLocale().toString(timing.total / timing.count, 'f', 2));
        }
    }
}

void ProgramModel::setPreview(const program::ProgramScript* script, const program::Preview* preview) {
    for (Node* node : nodes_) {
        node->result.clear();
        node->hasFinding = false;
    }
    if (preview != nullptr) {
        showTimings(*script, preview->timings);
        for (const program::Finding& finding : preview->findings) {
            const auto at = static_cast<std::size_t>(finding.step);
            Node* node =
                at >= 1 && at <= script->steps.size() ? nodes_.value(script->steps[at - 1].step) : nullptr;
            if (node != nullptr && !node->hasFinding) {
                node->hasFinding = true;
                node->result = finding.text;
            }
        }
    }
    changed();
}

void ProgramModel::setBreakpoints(const QSet<QUuid>& steps) {
    breakpoints_ = steps;
    changed();
}

void ProgramModel::setChanged(const QSet<QUuid>& steps) {
    if (steps != changed_) {
        changed_ = steps;
        changed();
    }
}

void ProgramModel::setRun(const program::ProgramScript& script, const program::StepLog& log, bool isActive) {
    for (Node* node : nodes_) {
        if (!node->hasFinding) {
            node->result.clear();
        }
    }
    showTimings(script, log.timings());
    // Use the step of the log only during a run. After a lost connection, the log keeps the last known step.
    const QUuid before = running_;
    running_ =
        isActive && log.step() > 0 ? script.steps[static_cast<std::size_t>(log.step() - 1)].step : QUuid();
    changed();
    if (running_ != before) {
        Q_EMIT runningStepMoved(indexOf(before), indexOf(running_));
    }
}

void ProgramModel::setRecovery(const program::ProgramScript* script, const program::RecoveryMap* map) {
    for (Node* node : nodes_) {
        node->recovery = {};
    }
    for (std::size_t i = 0; map != nullptr && i < map->steps.size(); ++i) {
        if (Node* node = nodes_.value(script->steps[i].step);
            node != nullptr && script->steps[i].program == program_.id) {
            node->recovery = map->steps[i];
        }
    }
    changed();
}

ProgramModel::Node* ProgramModel::nodeAt(const QModelIndex& index) const {
    return index.isValid() ? static_cast<Node*>(index.internalPointer()) : root_.get();
}

QUuid ProgramModel::idAt(const QModelIndex& index) const {
    return index.isValid() ? nodeAt(index)->step->id : QUuid();
}

QModelIndex ProgramModel::indexOf(const QUuid& id) const {
    Node* node = nodes_.value(id);
    return node != nullptr ? createIndex(node->row, 0, node) : QModelIndex();
}

QString ProgramModel::noteAt(const QUuid& id) const {
    const Node* node = nodes_.value(id);
    return node == nullptr            ? QString()
           : !node->problem.isEmpty() ? node->problem
           : node->hasFinding         ? node->result
                                      : QString();
}

QModelIndex ProgramModel::index(int row, int column, const QModelIndex& parent) const {
    const Node* node = nodeAt(parent);
    return row >= 0 && row < static_cast<int>(node->children.size()) && column >= 0 && column < kColumns
               ? createIndex(row, column, node->children[static_cast<std::size_t>(row)].get())
               : QModelIndex();
}

QModelIndex ProgramModel::parent(const QModelIndex& index) const {
    Node* parent = index.isValid() ? nodeAt(index)->parent : nullptr;
    return parent == nullptr || parent == root_.get() ? QModelIndex() : createIndex(parent->row, 0, parent);
}

int ProgramModel::rowCount(const QModelIndex& parent) const {
    return parent.column() > 0 ? 0 : static_cast<int>(nodeAt(parent)->children.size());
}

int ProgramModel::columnCount(const QModelIndex&) const {
    return kColumns;
}

bool ProgramModel::isRunning(const Node& node) const {
    return !running_.isNull() && node.step->id == running_;
}

QVariant ProgramModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) {
        return {};
    }
    const Node& node = *nodeAt(index);
    // Compute the text on demand for the visible rows, because a program can have thousands of steps.
    const auto text = [&] {
        switch (index.column()) {
            case Step:
                return QStringLiteral("%1  %2").arg(node.number).arg(program::kindName(*node.step));
            case Values:
                return program::summaryOf(*project_, *node.step);
            default:
                return !node.problem.isEmpty()                      ? node.problem
                       : node.hasFinding || node.recovery.from == 0 ? node.result
                                                                    : program::recoveryMark(node.recovery);
        }
    };
    const bool isChanged = changed_.contains(node.step->id);
    const bool hasBreakpoint = breakpoints_.contains(node.step->id);
    switch (role) {
        case Qt::DisplayRole:
            return isRunning(node) && index.column() == Step
                       ? (hasBreakpoint ? QStringLiteral("● ▶ ") : QStringLiteral("▶ ")) + text()
                   : hasBreakpoint && index.column() == Step     ? QStringLiteral("● ") + text()
                   : node.isMarked() && index.column() != Values ? QStringLiteral("⚠ ") + text()
                                                                 : text();
        case Qt::ToolTipRole:
            return index.column() == Result && !node.isMarked() && node.recovery.from > 0
                       ? program::recoveryDetails(node.recovery)
                       : text();
        case Qt::AccessibleTextRole:
            return node.step->disabled && index.column() == Step ? tr("%1, disabled").arg(text())
                   : isRunning(node) && index.column() == Step   ? tr("%1, running").arg(text())
                   : hasBreakpoint && index.column() == Step     ? tr("%1, breakpoint").arg(text())
                   : isChanged && index.column() == Step         ? tr("%1, changed").arg(text())
                                                                 : text();
        case Qt::FontRole: {
            QFont font;
            font.setStrikeOut(node.step->disabled);
            font.setItalic(node.isComment());
            font.setBold(isRunning(node));
            return font;
        }
        case Qt::BackgroundRole:
            return isChanged ? QVariant(Theme::current().warningBackground) : QVariant();
        case Qt::ForegroundRole:
            return node.step->disabled || node.isComment() ? QVariant(Theme::current().secondary)
                                                           : QVariant();
        default:
            return {};
    }
}

QVariant ProgramModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    return section == Step ? tr("Step") : section == Values ? tr("Values") : tr("Result");
}

Qt::ItemFlags ProgramModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) {
        return Qt::ItemIsDropEnabled;
    }
    const Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsDragEnabled;
    return nodeAt(index)->isSection() ? flags | Qt::ItemIsDropEnabled : flags;
}

// ---- drag and drop --------------------------------------------------------------------------------------

QStringList ProgramModel::mimeTypes() const {
    return {QLatin1String(kIdsMime), QLatin1String(kStepsMime)};
}

QMimeData* ProgramModel::mimeData(const QModelIndexList& indexes) const {
    QSet<QUuid> ids;
    QStringList texts;
    for (const QModelIndex& index : indexes) {
        if (index.column() == 0) {
            ids.insert(idAt(index));
            texts.append(idAt(index).toString());
        }
    }
    auto* data = new QMimeData;
    data->setData(QLatin1String(kStepsMime), program::textOf(program::selectedSteps(program_, ids)));
    // Store the program ID, because step IDs are valid only in this program. Dropping on a different program
    // copies the steps.
    texts.prepend(program_.id.toString());
    data->setData(QLatin1String(kIdsMime), texts.join(QLatin1Char(' ')).toLatin1());
    return data;
}

Qt::DropActions ProgramModel::supportedDropActions() const {
    return Qt::MoveAction | Qt::CopyAction;
}

bool ProgramModel::canDropMimeData(const QMimeData* data, Qt::DropAction, int, int,
                                   const QModelIndex& parent) const {
    return data->hasFormat(QLatin1String(kStepsMime)) && (!parent.isValid() || nodeAt(parent)->isSection());
}

bool ProgramModel::dropMimeData(const QMimeData* data, Qt::DropAction action, int row, int column,
                                const QModelIndex& parent) {
    if (!canDropMimeData(data, action, row, column, parent)) {
        return false;
    }
    const program::StepPosition at{idAt(parent), row >= 0 ? row : rowCount(parent.siblingAtColumn(0))};
    const QStringList ids =
        QString::fromLatin1(data->data(QLatin1String(kIdsMime))).split(QLatin1Char(' '), Qt::SkipEmptyParts);
    if (action == Qt::MoveAction && !program_.id.isNull() && ids.value(0) == program_.id.toString()) {
        QSet<QUuid> moved;
        for (const QString& id : ids.mid(1)) {
            moved.insert(QUuid(id));
        }
        Q_EMIT stepsMoved(at, moved);
    } else if (const auto steps = program::stepsFromText(data->data(QLatin1String(kStepsMime)))) {
        Q_EMIT stepsDropped(at, *steps);
    }
    // Return false, so that the view does not remove the dragged rows. The edit of the project updates the
    // model.
    return false;
}

}  // namespace tiller

#include "moc_program_model.cpp"
