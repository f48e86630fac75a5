// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/perspectives.h"

#include <algorithm>
#include <array>

#include "app/dock_stage.h"

namespace tiller::app {

using control::StopCause;

namespace {

struct BuiltIn {
    const char* id;
    const char* name;
    const char* help;
    Qt::Key key;  ///< shortcut together with Shift
    const char* tab;
    StagePlan plan;
};

const std::array<BuiltIn, 3>& builtIns() {
    static const std::array<BuiltIn, 3> all = {
        {{"teach",
          QT_TRANSLATE_NOOP("tiller::app::Perspectives", "Teach"),
          QT_TRANSLATE_NOOP("tiller::app::Perspectives",
                            "Shows the view, the waypoints next to it and the plots below."),
          Qt::Key_F6,
          "waypoints",
          {{{"viewDock"}, {"tabsDock", 29}}, "plotsDock", 36}},
         {"monitor",
          QT_TRANSLATE_NOOP("tiller::app::Perspectives", "Monitor"),
          QT_TRANSLATE_NOOP("tiller::app::Perspectives",
                            "Shows inputs and outputs, a smaller view next to them and taller plots below."),
          Qt::Key_F7,
          "io",
          {{{"tabsDock"}, {"viewDock", 29}}, "plotsDock", 45}},
         {"plots",
          QT_TRANSLATE_NOOP("tiller::app::Perspectives", "Plots"),
          QT_TRANSLATE_NOOP("tiller::app::Perspectives", "Shows only the plots, as large as possible."),
          Qt::Key_F8,
          "",
          {{{"viewDock", 0, false}, {"tabsDock", 29, false}}, "plotsDock", 0}}}};
    return all;
}

const BuiltIn* builtIn(const QString& id) {
    const auto found = std::find_if(builtIns().begin(), builtIns().end(),
                                    [&id](const BuiltIn& one) { return id == QLatin1String(one.id); });
    return found != builtIns().end() ? &*found : nullptr;
}

QString idOf(const SavedPerspective& saved) {
    return QStringLiteral("saved.%1").arg(saved.number);
}

}  // namespace

Perspectives::Perspectives(DockStage& stage, Settings& settings, Journal& journal, Hooks hooks,
                           QObject* parent)
    : QObject(parent)
    , stage_(stage)
    , settings_(settings)
    , journal_(journal)
    , hooks_(std::move(hooks))
    , saved_(settings.perspectives()) {
    bring(QLatin1String(builtIns().front().id));
    connect(&stage_, &DockStage::rearranged, this, [this] {
        changed_ = true;
        hooks_.stop(StopCause::SelectionChanged);
    });
    connect(&stage_, &DockStage::attentionLost, this, [this](StopCause cause) { hooks_.stop(cause); });
}

QList<Perspectives::Entry> Perspectives::all() const {
    QList<Entry> entries;
    for (const BuiltIn& one : builtIns()) {
        entries.append({QString::fromLatin1(one.id), tr(one.name), tr(one.help),
                        QKeySequence(Qt::SHIFT | one.key), true});
    }
    for (const SavedPerspective& saved : saved_) {
        entries.append({idOf(saved), saved.name, tr("Shows the panels as you saved them."), {}, false});
    }
    return entries;
}

Perspectives::Entry Perspectives::current() const {
    const QList<Entry> entries = all();
    const auto found = std::find_if(entries.begin(), entries.end(),
                                    [this](const Entry& entry) { return entry.id == current_; });
    return found != entries.end() ? *found : entries.front();
}

SavedPerspective* Perspectives::savedOf(const QString& id) {
    const auto found = std::find_if(saved_.begin(), saved_.end(),
                                    [&id](const SavedPerspective& saved) { return idOf(saved) == id; });
    return found != saved_.end() ? &*found : nullptr;
}

bool Perspectives::isKnown(const QString& id) const {
    const QList<Entry> entries = all();
    return std::any_of(entries.begin(), entries.end(), [&id](const Entry& entry) { return entry.id == id; });
}

void Perspectives::choose(const QString& id) {
    hooks_.stop(StopCause::SelectionChanged);
    if (!bring(id)) {
        const SavedPerspective* saved = savedOf(id);
        fallBack(tr("The perspective “%1” cannot be shown because the stored layout is damaged. Arrange the "
                    "panels and save the perspective again.")
                     .arg(saved != nullptr ? saved->name : id));
    }
}

bool Perspectives::bring(const QString& id) {
    QString tab;
    if (const BuiltIn* one = builtIn(id)) {
        stage_.arrange(one->plan);
        tab = QString::fromLatin1(one->tab);
    } else {
        const SavedPerspective* saved = savedOf(id);
        if (saved == nullptr || saved->panels.isEmpty() || !stage_.restore(saved->panels)) {
            return false;
        }
        tab = saved->tab;
    }
    current_ = id;
    changed_ = false;
    if (!tab.isEmpty()) {
        hooks_.showTab(tab);
    }
    Q_EMIT currentChanged();
    return true;
}

void Perspectives::fallBack(const QString& why) {
    bring(QLatin1String(builtIns().front().id));
    journal_.add(Severity::Warning, why);
}

QString Perspectives::obstacle(const QString& name, const QString& except) const {
    const QString wanted = name.trimmed();
    if (wanted.isEmpty()) {
        return tr("Enter a name.");
    }
    if (wanted.size() > kMaxPerspectiveName) {
        return tr("The name is too long. Enter a shorter name.");
    }
    if (except.isEmpty() && saved_.size() >= kMaxPerspectives) {
        return tr("The maximum number of perspectives has been reached. Delete a perspective first.");
    }
    const QList<Entry> entries = all();
    const bool taken = std::any_of(entries.begin(), entries.end(), [&](const Entry& entry) {
        return entry.id != except && entry.name.compare(wanted, Qt::CaseInsensitive) == 0;
    });
    return taken ? tr("A perspective with this name already exists. Choose a different name.") : QString();
}

void Perspectives::saveAs(const QString& name) {
    int number = 1;
    for (const SavedPerspective& saved : std::as_const(saved_)) {
        number = std::max(number, saved.number + 1);
    }
    saved_.append({number, name.trimmed(), hooks_.tab(), stage_.state()});
    changed_ = false;
    write();
    current_ = idOf(saved_.last());
    Q_EMIT currentChanged();
}

void Perspectives::save() {
    if (SavedPerspective* saved = savedOf(current_)) {
        saved->tab = hooks_.tab();
        saved->panels = stage_.state();
        changed_ = false;
        write();
    }
}

void Perspectives::rename(const QString& id, const QString& name) {
    if (SavedPerspective* saved = savedOf(id)) {
        saved->name = name.trimmed();
        write();
    }
}

void Perspectives::remove(const QString& id) {
    saved_.removeIf([&id](const SavedPerspective& saved) { return idOf(saved) == id; });
    write();
    if (current_ == id) {
        // Change only the selection, and keep the arrangement.
        current_ = QString::fromLatin1(builtIns().front().id);
        changed_ = true;
        Q_EMIT currentChanged();
    }
}

void Perspectives::write() {
    saved_ = settings_.setPerspectives(saved_);
    Q_EMIT listChanged();
}

void Perspectives::restoreLast() {
    const LastArrangement last = settings_.arrangement();
    const QString first = current().name;
    switch (last.found) {
        case LastArrangement::Found::Nothing:
            return;
        case LastArrangement::Found::Older:
            fallBack(
                tr("The panel layout was reset to the perspective “%1”: the layout of the earlier version is "
                   "not compatible. Arrange the panels again. The new layout is saved automatically.")
                    .arg(first));
            return;
        case LastArrangement::Found::Usable:
            if (!last.changed && isKnown(last.perspective)) {
                choose(last.perspective);
                return;
            }
            if (stage_.restore(last.panels)) {
                current_ = isKnown(last.perspective) ? last.perspective : current_;
                changed_ = true;
                Q_EMIT currentChanged();
                return;
            }
            break;
        case LastArrangement::Found::Damaged:
            break;
    }
    fallBack(tr("The panel layout was reset to the perspective “%1”: the stored layout is damaged or from "
                "another version. Arrange the panels again. The new layout is saved automatically.")
                 .arg(first));
}

void Perspectives::restoreSizes() {
    const LastArrangement last = settings_.arrangement();
    if (changed_ && last.changed && last.found == LastArrangement::Found::Usable) {
        stage_.restore(last.panels);
    }
}

void Perspectives::readAgain() {
    saved_ = settings_.perspectives();
    Q_EMIT listChanged();
    restoreLast();
}

void Perspectives::keep(int jogWidth) {
    settings_.setArrangement({LastArrangement::Found::Usable, current_, changed_, stage_.state(), jogWidth});
}

}  // namespace tiller::app

#include "moc_perspectives.cpp"
