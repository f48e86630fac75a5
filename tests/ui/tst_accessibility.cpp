// SPDX-License-Identifier: GPL-3.0-or-later
//
// Use without a mouse and with a screen reader: every control has a name, can be reached by Tab or a command,
// and shows the focus.

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QComboBox>
#include <QDialog>
#include <QLineEdit>
#include <QPointer>
#include <QSet>
#include <QTabBar>
#include <QTabWidget>
#include <QTest>
#include <algorithm>

#include "app/action_table.h"
#include "app/command_palette.h"
#include "resources/resources.h"
#include "robot/station/program/step_kind.h"
#include "tests/support/window_bench.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/segmented_control.h"
#include "widgets/common/theme.h"
#include "widgets/program/step_tree.h"
#include "widgets/project/undoable_document.h"
#include "widgets/waypoints/waypoints_tab.h"

using namespace tiller;
using namespace tiller::test;

namespace {

struct Bench : WindowBench {
    Bench() { show(QSize(1280, 720)); }
};

/// True for the viewport of a scroll area, which uses the name and focus of the area.
bool isViewport(const QWidget& widget) {
    const auto* area = qobject_cast<const QAbstractScrollArea*>(widget.parentWidget());
    return area != nullptr && area->viewport() == &widget;
}

bool isQtsOwn(const QWidget& widget) {
    return widget.objectName().startsWith("qt_") || isViewport(widget) ||
           widget.inherits("QTableCornerButton") || widget.inherits("QLineEditIconButton") ||
           widget.inherits("QToolBarExtension") || widget.inherits("QHeaderView") ||
           widget.inherits("QScrollBar") || widget.inherits("QComboBoxListView") ||
           qobject_cast<const QTabBar*>(widget.parent()) != nullptr ||
           (widget.parentWidget() != nullptr && widget.parentWidget()->inherits("QAbstractSpinBox"));
}

bool isControl(const QWidget& widget) {
    return qobject_cast<const QAbstractButton*>(&widget) || qobject_cast<const QLineEdit*>(&widget) ||
           qobject_cast<const QAbstractItemView*>(&widget) || qobject_cast<const QAbstractSlider*>(&widget) ||
           qobject_cast<const QComboBox*>(&widget) || qobject_cast<const QTabBar*>(&widget) ||
           (widget.focusPolicy() & Qt::TabFocus) != 0;
}

QStringList nameless(const QWidget& root) {
    QStringList without;
    for (const QWidget* widget : root.findChildren<QWidget*>()) {
        if (!isControl(*widget) || isQtsOwn(*widget)) {
            continue;
        }
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        if (widget->accessibleName().isEmpty() && (button == nullptr || button->text().isEmpty())) {
            without << QStringLiteral("%1 \"%2\" in %3")
                           .arg(QLatin1String(widget->metaObject()->className()), widget->objectName(),
                                widget->parentWidget() ? widget->parentWidget()->objectName() : QString());
        }
    }
    return without;
}

}  // namespace

class TestAccessibility : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() {
        initResources();
        applyTheme(*qApp, Theme::light());
    }

    void everyControlOfTheWindowHasAName() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.window.waypoints().teach();
        bench.cell.advanceMs(100);
        project::ProgramList programs;
        const project::ProgramStep move = program::newStep(*program::findStepKind("moveL"));
        programs.append({QUuid::createUuid(), "program", {}, {move}, {}, {}});
        bench.window.document().changePrograms(programs, "add");
        bench.find<StepTree>("program.tree").selectIds({move.id});
        const QStringList without = nameless(bench.window);
        QVERIFY2(without.isEmpty(), qPrintable(without.join('\n')));
    }

    void everyControlOfEveryDialogHasAName() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.cell.robot.protectiveStop();
        bench.cell.advanceMs(300);
        int dialogs = 0;
        for (const char* id : {"robot.connect", "robot.check", "power.recover", "control.load",
                               "app.settings", "app.palette", "app.help", "jog.devices"}) {
            QAction* action = bench.window.actions().find(QLatin1String(id));
            QVERIFY2(action != nullptr, id);
            action->setEnabled(true);
            action->trigger();
            QCoreApplication::processEvents();
            // QPointer, because the children of a dialog are destroyed with it.
            QList<QPointer<QWidget>> tops;
            for (QWidget* top : QApplication::topLevelWidgets()) {
                tops.append(top);
            }
            for (const QPointer<QWidget>& top : std::as_const(tops)) {
                if (top != nullptr && top != &bench.window && top->isVisible() &&
                    qobject_cast<QDialog*>(top) != nullptr) {
                    ++dialogs;
                    // The label of a QInputDialog is the name of its field.
                    if (!top->inherits("QInputDialog")) {
                        const QStringList without = nameless(*top);
                        QVERIFY2(without.isEmpty(),
                                 qPrintable(QLatin1String(id) + ": " + without.join('\n')));
                    }
                    top->close();
                }
            }
        }
        QCOMPARE(dialogs, 8);
    }

    void tabReachesEveryControlWithoutACommand() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(100);
        QSet<QWidget*> reached;
        for (int i = 0; i < 400; ++i) {
            QTest::keyClick(&bench.window, Qt::Key_Tab);
            QWidget* focus = QApplication::focusWidget();
            QVERIFY(focus != nullptr);
            if (reached.contains(focus) && i > 200) {
                break;
            }
            reached.insert(focus);
        }
        QStringList missed;
        for (QWidget* widget : bench.window.findChildren<QWidget*>()) {
            const bool visible =
                widget->isVisible() && widget->isEnabled() && widget->window() == &bench.window;
            if (!visible || !isControl(*widget) || isQtsOwn(*widget) || reached.contains(widget)) {
                continue;
            }
            // In a group of exclusive buttons, Tab reaches one button and the arrow keys reach the other
            // buttons.
            if (widget->parentWidget() != nullptr &&
                widget->parentWidget()->inherits("tiller::SegmentedControl")) {
                const QList<QAbstractButton*> row = widget->parentWidget()->findChildren<QAbstractButton*>();
                if (std::any_of(row.begin(), row.end(), [&](auto* key) { return reached.contains(key); })) {
                    continue;
                }
            }
            // The armed keyboard replaces hold-to-run buttons, and Space and Esc replace STOP.
            if (qobject_cast<HoldToRunButton*>(widget) != nullptr || widget->objectName() == "stopButton" ||
                widget->focusPolicy() == Qt::NoFocus) {
                if (qobject_cast<HoldToRunButton*>(widget) != nullptr ||
                    widget->objectName() == "stopButton") {
                    continue;
                }
            }
            missed << QStringLiteral("%1 \"%2\" (%3)")
                          .arg(QLatin1String(widget->metaObject()->className()), widget->objectName(),
                               widget->accessibleName());
        }
        QVERIFY2(reached.size() > 15, qPrintable(QString::number(reached.size())));
        QVERIFY2(missed.isEmpty(), qPrintable(missed.join('\n')));
    }

    void arrowKeysMoveThroughARowOfButtons() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        auto* motion = bench.window.findChild<SegmentedControl*>("jogMotion");
        motion->segment(motion->currentIndex())->setFocus(Qt::TabFocusReason);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Right);
        QCOMPARE(motion->currentIndex(), 1);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Left);
        QCOMPARE(motion->currentIndex(), 0);
    }

    void theFocusIsVisible() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.cell.advanceMs(100);
        QSet<QWidget*> looked;
        QStringList invisible;
        for (int i = 0; i < 200; ++i) {
            QTest::keyClick(&bench.window, Qt::Key_Tab);
            QWidget* focus = QApplication::focusWidget();
            QVERIFY(focus != nullptr);
            if (looked.contains(focus)) {
                continue;
            }
            looked.insert(focus);
            const QImage with = focus->grab().toImage();
            focus->clearFocus();
            const QImage without = focus->grab().toImage();
            focus->setFocus(Qt::TabFocusReason);
            if (with == without) {
                invisible << QStringLiteral("%1 \"%2\"")
                                 .arg(QLatin1String(focus->metaObject()->className()), focus->objectName());
            }
        }
        QVERIFY(looked.size() > 15);
        QVERIFY2(invisible.isEmpty(), qPrintable(invisible.join('\n')));
    }

    void tablesAndListsShowTheirFocus() {
        Bench bench;
        QVERIFY2(bench.cell.bringUp(), qPrintable(bench.cell.what()));
        bench.window.waypoints().teach();
        bench.cell.advanceMs(100);
        int looked = 0;
        QStringList invisible;
        const auto look = [&](QWidget& window) {
            for (auto* view : window.findChildren<QAbstractItemView*>()) {
                if (!view->isVisible() || view->window() != &window || isQtsOwn(*view) ||
                    view->focusPolicy() == Qt::NoFocus) {
                    continue;
                }
                ++looked;
                // The frame must show the focus with and without a selection.
                view->clearSelection();
                view->setCurrentIndex({});
                view->clearFocus();
                const QImage without = view->grab().toImage();
                view->setFocus(Qt::TabFocusReason);
                const QImage with = view->grab().toImage();
                int changed = 0;
                for (int x = 0; x < with.width(); ++x) {
                    changed += with.pixel(x, 0) != without.pixel(x, 0) ? 1 : 0;
                }
                if (changed < with.width() / 2) {
                    invisible << view->objectName();
                }
            }
        };
        for (const char* tab : {"waypoints", "program", "log"}) {
            bench.window.showTab(tab);
            QCoreApplication::processEvents();
            look(bench.window);
        }
        for (const char* id : {"app.palette", "app.settings"}) {
            bench.window.actions().find(QLatin1String(id))->trigger();
            QDialog* dialog = nullptr;
            for (QWidget* top : QApplication::topLevelWidgets()) {
                dialog =
                    top->isVisible() && qobject_cast<QDialog*>(top) ? qobject_cast<QDialog*>(top) : dialog;
            }
            QVERIFY2(dialog != nullptr && QTest::qWaitForWindowActive(dialog), id);
            if (auto* pages = dialog->findChild<QTabWidget*>()) {
                pages->setCurrentIndex(pages->count() - 1);
            }
            QCoreApplication::processEvents();
            look(*dialog);
            dialog->close();
            QCoreApplication::processEvents();
        }
        QCOMPARE(looked, 6);
        QVERIFY2(invisible.isEmpty(), qPrintable(invisible.join('\n')));
    }

    void everyFunctionIsACommandWithANameAndHelp() {
        Bench bench;
        QSet<QString> names;
        for (const QAction* action : bench.window.actions().all()) {
            QVERIFY2(!action->objectName().isEmpty() && !action->text().isEmpty(),
                     qPrintable(action->text()));
            QVERIFY2(!names.contains(action->objectName()), qPrintable(action->objectName()));
            names.insert(action->objectName());
            for (const QAction* other : bench.window.actions().all()) {
                QVERIFY2(other == action || action->shortcut().isEmpty() ||
                             other->shortcut() != action->shortcut() ||
                             !app::ActionTable::share(*action, *other),
                         qPrintable(action->shortcut().toString() + " twice"));
            }
        }
        QVERIFY(names.size() > 30);
        const QString help = bench.window.actions().helpText();
        for (const QAction* action : bench.window.actions().all()) {
            QVERIFY2(help.contains(QString(action->text()).remove('&').toHtmlEscaped()),
                     qPrintable(action->text()));
        }
    }

    void thePaletteWorksWithTheKeyboardAlone() {
        Bench bench;
        QTest::keyClick(&bench.window, Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY_WITH_TIMEOUT(bench.window.findChild<app::CommandPalette*>() != nullptr, 60'000);
        auto* palette = bench.window.findChild<app::CommandPalette*>();
        auto* words = palette->findChild<QLineEdit*>("paletteWords");
        QTest::keyClicks(words, "show log");
        QCOMPARE(palette->listed().first()->objectName(), QString("view.log"));
        QTest::keyClick(words, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(bench.window.findChild<app::CommandPalette*>() == nullptr, 60'000);
        auto* tabs = bench.window.findChild<QTabBar*>("tabs");
        QCOMPARE(tabs->tabData(tabs->currentIndex()).toString(), QString("log"));
    }
};

QTEST_MAIN(TestAccessibility)
#include "tst_accessibility.moc"
