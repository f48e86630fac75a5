// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/action_table.h"

#include <QApplication>
#include <QKeyEvent>
#include <QWidget>
#include <algorithm>

#include "widgets/hold/physical_keys.h"

namespace tiller::app {
namespace {

constexpr char kMenu[] = "tillerMenu";
constexpr char kHelp[] = "tillerHelp";
constexpr char kObstacle[] = "tillerObstacle";
constexpr char kBuiltIn[] = "tillerBuiltInKeys";

/// Translation context of this file for lupdate.
struct MenuText {
    Q_DECLARE_TR_FUNCTIONS(ActionTable)
};

void showObstacle(QAction& action, const QString& obstacle) {
    action.setProperty(kObstacle, obstacle);
    action.setEnabled(obstacle.isEmpty());
    const QString help = ActionTable::helpOf(action);
    action.setToolTip(obstacle.isEmpty() ? help : obstacle);
}

}  // namespace

QString plain(const QAction& action) {
    return QString(action.text()).remove(QLatin1Char('&'));
}

QList<QPair<QString, QString>> actionMenus() {
    return {{"robot", MenuText::tr("Robot")},
            {"project", MenuText::tr("Project")},
            {"power", MenuText::tr("Power and safety")},
            {"control", MenuText::tr("Control and programs")},
            {"jog", MenuText::tr("Jog")},
            {"waypoint", MenuText::tr("Waypoints")},
            {"program", MenuText::tr("Program steps")},
            {"frame", MenuText::tr("Frames")},
            {"tool", MenuText::tr("Tools")},
            {"io", MenuText::tr("I/O")},
            {"log", MenuText::tr("Log")},
            {"plots", MenuText::tr("Plots")},
            {"view", MenuText::tr("View")},
            {"perspective", MenuText::tr("Perspectives")},
            {"panel", MenuText::tr("Move panels")},
            {"app", MenuText::tr("Application")}};
}

ActionTable::ActionTable(QWidget& owner) : QObject(&owner), owner_(owner) {
    qApp->installEventFilter(this);
}

QAction* ActionTable::add(ActionSpec spec) {
    auto* action = new QAction(spec.text, this);
    action->setObjectName(spec.id);
    action->setShortcut(spec.shortcut);
    action->setProperty(kHelp, spec.help);
    action->setStatusTip(spec.help);
    action->setAutoRepeat(false);
    connect(action, &QAction::triggered, this, [run = std::move(spec.run)] { run(); });
    owner_.addAction(action);
    adopt(spec.id.section(QLatin1Char('.'), 0, 0), action);
    showObstacle(*action, {});
    if (spec.obstacle) {
        rules_.push_back({action, std::move(spec.obstacle)});
    }
    return action;
}

void ActionTable::adopt(const QString& menu, QAction* action) {
    action->setProperty(kMenu, menu);
    action->setProperty(kBuiltIn, QVariant::fromValue(action->shortcut()));
    if (const auto own = chosen_.constFind(action->objectName()); own != chosen_.constEnd()) {
        action->setShortcut(*own);
    }
    actions_.append(action);
}

void ActionTable::remove(QAction* action) {
    actions_.removeOne(action);
    std::erase_if(rules_, [action](const Rule& rule) { return rule.action == action; });
    owner_.removeAction(action);
    // Delete the action later, because it may be running.
    action->deleteLater();
}

QList<QAction*> ActionTable::inMenu(const QString& menu) const {
    QList<QAction*> found;
    for (QAction* action : actions_) {
        if (menuOf(*action) == menu) {
            found.append(action);
        }
    }
    return found;
}

QAction* ActionTable::find(const QString& id) const {
    for (QAction* action : actions_) {
        if (action->objectName() == id) {
            return action;
        }
    }
    return nullptr;
}

QString ActionTable::menuOf(const QAction& action) {
    return action.property(kMenu).toString();
}

QString ActionTable::helpOf(const QAction& action) {
    const QString help = action.property(kHelp).toString();
    return help.isEmpty() ? action.text() : help;
}

QString ActionTable::obstacleOf(const QAction& action) {
    return action.property(kObstacle).toString();
}

bool ActionTable::share(const QAction& a, const QAction& b) {
    const bool apart = a.shortcutContext() == Qt::WidgetWithChildrenShortcut &&
                       b.shortcutContext() == Qt::WidgetWithChildrenShortcut && a.parent() != b.parent();
    return !apart;
}

QKeySequence ActionTable::builtInShortcut(const QAction& action) {
    return action.property(kBuiltIn).value<QKeySequence>();
}

void ActionTable::setShortcuts(const QMap<QString, QKeySequence>& chosen) {
    chosen_ = chosen;
    for (QAction* action : actions_) {
        const auto own = chosen.constFind(action->objectName());
        action->setShortcut(own == chosen.constEnd() ? builtInShortcut(*action) : *own);
    }
}

QAction* ActionTable::heardAt(const QWidget& focus, const QKeySequence& keys) const {
    const auto hears = [&](const QAction& action) {
        const QObjectList owners = action.associatedObjects();
        return std::any_of(owners.begin(), owners.end(), [&](const QObject* owner) {
            const auto* widget = qobject_cast<const QWidget*>(owner);
            return widget != nullptr && widget->isVisible() && widget->isEnabled() &&
                   (action.shortcutContext() == Qt::WindowShortcut || widget == &focus ||
                    (action.shortcutContext() == Qt::WidgetWithChildrenShortcut &&
                     widget->isAncestorOf(&focus)));
        });
    };
    const auto found = std::find_if(actions_.begin(), actions_.end(), [&](const QAction* action) {
        return action->isEnabled() && action->shortcuts().contains(keys) && hears(*action);
    });
    return found != actions_.end() ? *found : nullptr;
}

bool ActionTable::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress || !watched->isWidgetType()) {
        return false;
    }
    const auto& press = *static_cast<QKeyEvent*>(event);
    const int letter = PhysicalKeys::keyOf(press);
    if (letter == press.key() || press.isAutoRepeat() || QApplication::activeModalWidget() != nullptr ||
        QApplication::activePopupWidget() != nullptr) {
        return false;
    }
    auto* focus = static_cast<QWidget*>(watched);
    QWidget* window = focus->window();
    if (window->windowType() == Qt::Tool && window->parentWidget() != nullptr) {
        window = window->parentWidget()->window();  // the focus is in a floating dock
    }
    QAction* action = window == &owner_
                          ? heardAt(*focus, QKeySequence(QKeyCombination(press.modifiers(), Qt::Key(letter))))
                          : nullptr;
    if (action == nullptr) {
        return false;
    }
    // Ask the focus widget first, as for every shortcut, because an input field needs the letter.
    QKeyEvent question(QEvent::ShortcutOverride, letter, press.modifiers(), press.nativeScanCode(),
                       press.nativeVirtualKey(), press.nativeModifiers(), press.text());
    question.ignore();
    QApplication::sendEvent(focus, &question);
    if (question.isAccepted()) {
        return false;
    }
    action->trigger();
    return true;
}

QString ActionTable::helpText() const {
    QString text;
    for (const auto& [menu, title] : actionMenus()) {
        const QList<QAction*> actions = inMenu(menu);
        if (actions.isEmpty()) {
            continue;
        }
        text += QStringLiteral("<h3>%1</h3><table cellpadding='4'>").arg(title.toHtmlEscaped());
        for (const QAction* action : actions) {
            text += QStringLiteral("<tr><td><b>%1</b></td><td><code>%2</code></td><td>%3</td></tr>")
                        .arg(QString(action->text()).remove(QLatin1Char('&')).toHtmlEscaped(),
                             action->shortcut().toString(QKeySequence::NativeText).toHtmlEscaped(),
                             helpOf(*action).toHtmlEscaped());
        }
        text += QStringLiteral("</table>");
    }
    return text;
}

void ActionTable::applyState(const SessionState& state) {
    for (const Rule& rule : rules_) {
        const QString obstacle = rule.obstacle(state);
        if (obstacle != obstacleOf(*rule.action)) {
            showObstacle(*rule.action, obstacle);
        }
    }
}

}  // namespace tiller::app

#include "moc_action_table.cpp"
