// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tab "Program": building, editing, checking and previewing a program.

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QScrollBar>
#include <QTest>
#include <QTreeWidget>

#include "program_samples.h"
#include "widgets/common/elided_label.h"
#include "widgets/program/import_report.h"
#include "widgets/program/program_model.h"
#include "widgets/program/program_tab.h"
#include "widgets/program/step_palette.h"
#include "widgets/program/step_tree.h"
#include "widgets/project/undoable_document.h"

using namespace tiller;
using namespace tiller::program;

class TestProgramTab : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() {
        document_ = std::make_unique<UndoableDocument>();
        document_->setProject(sampleProject());
        tab_ = std::make_unique<ProgramTab>(*document_);
        tab_->resize(1000, 500);
        tab_->show();
        QVERIFY(QTest::qWaitForWindowExposed(tab_.get()));
    }
    void cleanup() {
        tab_.reset();
        document_.reset();
    }

    void stepsAreAddedFromThePalette() {
        add("moveJ");
        QCOMPARE(document_->project().programs.size(), std::size_t(1));
        add("loop");
        add("wait");  // added to the selected empty loop
        QCOMPARE(shape(), QString("moveJ loop(wait)"));
        QCOMPARE(tree().selectedIds().size(), 1);
        document_->undo();
        QCOMPARE(shape(), QString("moveJ loop"));
        document_->redo();
        QCOMPARE(shape(), QString("moveJ loop(wait)"));
    }

    void stepsAreDroppedAndMoved() {
        openTray();
        const QModelIndex section = model().indexOf(steps()[3].id);  // Try
        QVERIFY(model().flags(section) & Qt::ItemIsDropEnabled);
        QVERIFY(!(model().flags(model().indexOf(steps()[0].id)) & Qt::ItemIsDropEnabled));
        const std::unique_ptr<QMimeData> dragged(
            model().mimeData({model().indexOf(steps()[1].id), model().indexOf(steps()[2].id)}));
        QVERIFY(model().canDropMimeData(dragged.get(), Qt::MoveAction, 0, 0, section));
        model().dropMimeData(dragged.get(), Qt::MoveAction, 0, 0, section);
        QCOMPARE(
            shape(),
            QString(
                "moveJ try(gripper assign forEachPlace(moveJ moveL gripper moveL moveL moveL gripper moveL "
                "assign)) onError(gripper log) moveJ"));
        model().dropMimeData(dragged.get(), Qt::CopyAction, 0, 0, {});
        QVERIFY(shape().startsWith("gripper assign moveJ try(gripper assign"));
        document_->undo();
        document_->undo();
        QVERIFY(shape().startsWith("moveJ gripper assign try(forEachPlace"));
    }

    void keysEditTheSelection() {
        openTray();
        tree().selectIds({steps()[1].id, steps()[2].id});
        tree().setFocus();
        QTest::keyClick(&tree(), Qt::Key_D, Qt::ControlModifier);
        QVERIFY2(shape().startsWith("moveJ gripper assign gripper assign try"), qPrintable(shape()));
        tree().selectIds({steps()[0].id});
        QTest::keyClick(&tree(), Qt::Key_Down, Qt::ControlModifier);
        QVERIFY2(shape().startsWith("gripper moveJ assign"), qPrintable(shape()));
        QTest::keyClick(&tree(), Qt::Key_Up, Qt::ControlModifier);
        QVERIFY2(shape().startsWith("moveJ gripper assign"), qPrintable(shape()));
        QTest::keyClick(&tree(), Qt::Key_X, Qt::ControlModifier);
        QVERIFY2(shape().startsWith("gripper assign gripper"), qPrintable(shape()));
        tree().selectIds({steps()[1].id});
        QTest::keyClick(&tree(), Qt::Key_V, Qt::ControlModifier);
        QVERIFY2(shape().startsWith("gripper assign moveJ gripper"), qPrintable(shape()));
        QTest::keyClick(&tree(), Qt::Key_Slash, Qt::ControlModifier);
        QVERIFY(steps()[2].disabled);
        QTest::keyClick(&tree(), Qt::Key_Slash, Qt::ControlModifier);
        QVERIFY(!steps()[2].disabled);
        const auto name = [&] { return model().indexOf(steps()[2].id).data().toString(); };
        QTest::keyClick(&tree(), Qt::Key_B, Qt::ControlModifier);
        QVERIFY2(name().startsWith("● "), qPrintable(name()));
        QTest::keyClick(&tree(), Qt::Key_B, Qt::ControlModifier);
        QVERIFY2(!name().startsWith("● "), qPrintable(name()));
        QTest::keyClick(&tree(), Qt::Key_Delete);
        QVERIFY2(shape().startsWith("gripper assign gripper"), qPrintable(shape()));
        QCOMPARE(document_->undoStack().undoText(), QString("Delete steps"));
    }

    void stepsAreCopiedToOtherProgramsAsText() {
        openTray();
        tree().selectIds({steps()[3].id});
        tree().setFocus();
        QTest::keyClick(&tree(), Qt::Key_C, Qt::ControlModifier);
        tab_->findChild<QAction*>("program.action.new")->trigger();
        QCOMPARE(document_->project().programs.size(), std::size_t(2));
        tree().setFocus();
        QTest::keyClick(&tree(), Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(document_->project().programs.at(1).steps.size(), std::size_t(1));
        QVERIFY(document_->project().programs.at(1).steps[0].id !=
                document_->project().programs.at(0).steps[3].id);
    }

    void fieldsAreEditedInTheirUnits() {
        openTray();
        const QUuid id = steps()[3].steps[0].steps[0].id;  // MoveJ before the pick position
        tree().selectIds({id});
        auto* before = field<QLineEdit>("before");
        QCOMPARE(before->text(), QString("50"));
        type(*before, "80");
        QCOMPARE(findStep(steps(), id)->fields["before"].toDouble(), 0.08);
        QCOMPARE(document_->undoStack().undoText(), QString("Change “Approach distance”"));
        auto* speed = field<QLineEdit>("speed");
        QCOMPARE(speed->text(), QString());
        type(*speed, "30");
        QVERIFY(std::abs(findStep(steps(), id)->fields["speed"].toDouble() - 0.5235987755982988) < 1e-12);
        type(*field<QLineEdit>("speed"), "");
        QVERIFY(!findStep(steps(), id)->fields.contains("speed"));
        auto* waypoint = field<QComboBox>("waypoint");
        QCOMPARE(waypoint->currentText(), QString("pick"));
        waypoint->setCurrentIndex(waypoint->findText("place"));
        Q_EMIT waypoint->activated(waypoint->currentIndex());
        QCOMPARE(findStep(steps(), id)->fields["waypoint"].toString(),
                 waypointId(document_->project(), "place"));
    }

    void valuesOutOfRangeAreRefused() {
        openTray();
        const QUuid id = steps()[1].id;
        tree().selectIds({id});
        auto* time = field<QLineEdit>("time");
        type(*time, "100");
        QCOMPARE(time->text(), QString("100"));
        QCOMPARE(findStep(steps(), id)->fields["time"].toDouble(), 0.2);
        QVERIFY(tab_->findChild<QLabel*>("program.refusal")->text().contains("between 0 s and 60 s"));
        type(*time, "fast");
        QCOMPARE(findStep(steps(), id)->fields["time"].toDouble(), 0.2);
    }

    void problemsAreShownAtTheirStep() {
        openTray();
        QVERIFY(QTest::qWaitFor([&] { return status().contains("can run"); }));
        add("moveL");
        QTRY_VERIFY2_WITH_TIMEOUT(status().contains("Set a waypoint"), qPrintable(status()), 60'000);
        QVERIFY(!key("program.preview")->isEnabled());
        const QUuid added = *tree().selectedIds().begin();
        const QModelIndex at = model().indexOf(added).siblingAtColumn(ProgramModel::Result);
        QVERIFY(at.data().toString().contains("Set a waypoint"));
        document_->undo();
        QTRY_VERIFY_WITH_TIMEOUT(key("program.preview")->isEnabled(), 60'000);
    }

    void previewShowsTimesAndFindings() {
        openTray();
        QTRY_VERIFY_WITH_TIMEOUT(key("program.preview")->isEnabled(), 60'000);
        click("program.preview");
        QTRY_VERIFY2_WITH_TIMEOUT(status().startsWith("Simulated"), qPrintable(status()), 60'000);
        const QModelIndex first = model().indexOf(steps()[0].id).siblingAtColumn(ProgramModel::Result);
        QVERIFY2(first.data().toString().startsWith("1 ×"), qPrintable(first.data().toString()));
        // An edit makes the preview outdated.
        tree().selectIds({steps()[1].id});
        type(*field<QLineEdit>("time"), "0.3");
        QTRY_VERIFY_WITH_TIMEOUT(status().contains("can run"), 60'000);
        QCOMPARE(first.data().toString(), QString());
    }

    // Widths of the tab in the default window at 1280 x 720 and 1920 x 1080.
    void theResultColumnIsVisible_data() {
        QTest::addColumn<int>("width");
        for (const int width : {370, 560, 900}) {
            QTest::newRow(qPrintable(QString::number(width))) << width;
        }
    }
    void theResultColumnIsVisible() {
        QFETCH(int, width);
        openTray();
        tab_->resize(width, 500);
        QTRY_VERIFY_WITH_TIMEOUT(key("program.preview")->isEnabled(), 60'000);
        click("program.preview");
        const auto resultOfFirst = [this] {
            return model().index(0, ProgramModel::Result).data().toString();
        };
        QTRY_VERIFY_WITH_TIMEOUT(!resultOfFirst().isEmpty(), 60'000);
        const QHeaderView& header = *tree().header();
        const auto visible = [&] {
            return tree().viewport()->width() - header.sectionViewportPosition(ProgramModel::Result);
        };
        QTRY_VERIFY_WITH_TIMEOUT(visible() >= header.sectionSizeHint(ProgramModel::Result), 60'000);
        QTRY_COMPARE_WITH_TIMEOUT(tree().horizontalScrollBar()->maximum(), 0, 60'000);
        QVERIFY(header.sectionSize(ProgramModel::Step) >= 40);
    }

    void theImportReportShowsItsResults() {
        ImportedProgram imported;
        imported.project = document_->project();
        project::Program program = makeProgram("imported", {step("comment", {{"text", "x"}})});
        imported.program = program.id;
        imported.project.programs.append(program);
        const QString code = QString(70, QLatin1Char('m'));
        imported.rows = {
            {1, code, ImportRow::Result::Step, "comment", program.steps[0].id, {}, false},
            {2, code, ImportRow::Result::Text, "script", {}, QString(120, QLatin1Char('n')), false}};
        ImportReport report(imported);
        report.show();
        QVERIFY(QTest::qWaitForWindowExposed(&report));
        auto& rows = *report.findChild<QTreeWidget*>("program.import.rows");
        QCOMPARE(rows.horizontalScrollBar()->maximum(), 0);
        QVERIFY2(rows.header()->sectionSize(2) >= 200,
                 qPrintable(QString::number(rows.header()->sectionSize(2))));
        QVERIFY(rows.header()->sectionSize(1) >= 150);
    }

    void recoverabilityIsShownUntilTheProgramChanges() {
        project::ProgramList programs;
        programs.append(makeProgram(
            "p", {step("moveJ", {{"waypoint", waypointId(document_->project(), "home")}}),
                  step("moveL", {{"waypoint", waypointId(document_->project(), "pick")}}),
                  step("wait", {{"time", 0.5}}), step("force", {}, {step("wait", {{"time", 0.2}})}),
                  step("moveL", {{"waypoint", waypointId(document_->project(), "home")}})}));
        document_->changePrograms(programs, "open");
        auto* action = tab_->findChild<QAction*>("program.action.recover");
        QTRY_VERIFY_WITH_TIMEOUT(action->isEnabled() && key("program.preview")->isEnabled(), 60'000);
        action->trigger();
        QVERIFY2(action->text().startsWith("Cancel"), qPrintable(action->text()));
        QTRY_VERIFY2_WITH_TIMEOUT(status().contains("in 3 of 6 steps"), qPrintable(status()), 60'000);
        QCOMPARE(action->text(), QStringLiteral("Check recoverability"));
        const auto cell = [&](const QUuid& id) {
            return model().indexOf(id).siblingAtColumn(ProgramModel::Result);
        };
        const QModelIndex second = cell(steps()[1].id);
        QVERIFY2(second.data().toString().contains("Move back"), qPrintable(second.data().toString()));
        QVERIFY(
            second.data(Qt::ToolTipRole).toString().contains("Power loss: can continue after moving back"));
        const QModelIndex inside = cell(steps()[3].steps[0].id);
        QVERIFY2(inside.data().toString().contains("Unsafe"), qPrintable(inside.data().toString()));
        QVERIFY(inside.data(Qt::ToolTipRole).toString().contains("force section"));
        // A connection loss at the end of the wait stops the program in the force section.
        QVERIFY(cell(steps()[2].id).data().toString().contains("Unsafe"));
        // An edit makes the marks outdated.
        tree().selectIds({steps()[2].id});
        type(*field<QLineEdit>("time"), "0.3");
        QTRY_COMPARE_WITH_TIMEOUT(second.data().toString(), QString(), 60'000);
        // The command cancels a running check.
        QTRY_VERIFY_WITH_TIMEOUT(action->isEnabled(), 60'000);
        action->trigger();
        action->trigger();
        QVERIFY2(status().contains("cancelled") || status().contains("imulati"), qPrintable(status()));
        QCOMPARE(action->text().startsWith("Cancel"), !status().contains("cancelled"));
    }

    void movesThatAWaypointEditChangesAreHighlighted() {
        const auto move = [this](const char* waypoint) {
            return program::step("moveL", {{"waypoint", waypointId(document_->project(), waypoint)}});
        };
        const std::vector<project::ProgramStep> moves{
            move("pick"), program::step("folder", {}, {move("pick"), move("place")}),
            program::step("moveGroup", {{"group", "row"}}), program::step("wait", {{"time", 0.1}})};
        project::ProgramList programs;
        programs.append(makeProgram("Test", moves));
        document_->changePrograms(programs, "steps");
        QVERIFY(QTest::qWaitFor([this] { return status().contains("can run"); }, 60'000));
        const auto isChanged = [this](const QUuid& id) {
            return model().indexOf(id).data(Qt::BackgroundRole).isValid() &&
                   model().indexOf(id).data(Qt::AccessibleTextRole).toString().endsWith("changed");
        };
        const QList<QUuid> ids{moves[0].id, moves[1].steps[0].id, moves[1].steps[1].id, moves[2].id,
                               moves[3].id};
        const auto changed = [&] {
            QString marks;
            for (const QUuid& id : ids) {
                marks += isChanged(id) ? 'x' : '-';
            }
            return marks;
        };
        const auto edit = [this](const char* name, auto change) {
            const int row = document_->waypoints().indexOf(QUuid(waypointId(document_->project(), name)));
            project::Waypoint waypoint = document_->waypoints().at(row);
            change(waypoint);
            document_->changeWaypoint(row, waypoint, "edit");
        };
        QCOMPARE(changed(), QString("-----"));
        edit("pick", [](project::Waypoint& waypoint) { waypoint.pose.position.x() += 0.01; });
        QTRY_COMPARE_WITH_TIMEOUT(changed(), QString("xx---"), 60'000);
        QVERIFY2(status().startsWith("2 step(s) changed"), qPrintable(status()));
        edit("row 2", [](project::Waypoint& waypoint) { waypoint.pose.position.x() += 0.01; });
        QTRY_COMPARE_WITH_TIMEOUT(changed(), QString("---x-"), 60'000);
        // A note changes no move, and an edit of the program ends the highlight.
        edit("row 2", [](project::Waypoint& waypoint) { waypoint.note = "n"; });
        QTRY_COMPARE_WITH_TIMEOUT(changed(), QString("-----"), 60'000);
        document_->undo();
        document_->undo();
        QTRY_COMPARE_WITH_TIMEOUT(changed(), QString("---x-"), 60'000);
        tree().selectIds({moves[3].id});
        tree().setFocus();
        QTest::keyClick(&tree(), Qt::Key_Up, Qt::ControlModifier);
        QTRY_COMPARE_WITH_TIMEOUT(changed(), QString("-----"), 60'000);
    }

    void selectionStaysWhileTheProgramChanges() {
        openTray();
        const QUuid id = steps()[3].steps[0].steps[2].id;
        tree().selectIds({id});
        tree().collapse(model().indexOf(steps()[4].id));
        project::ProgramList edited = document_->project().programs;
        project::Program program = edited.at(0);
        program.steps.erase(program.steps.begin());
        edited.replace(0, program);
        document_->changePrograms(edited, "remove");
        QCOMPARE(tree().selectedIds(), QSet<QUuid>{id});
        QVERIFY(!tree().isExpanded(model().indexOf(steps()[3].id)));
        QVERIFY(tree().isExpanded(model().indexOf(steps()[2].id)));
    }

private:
    StepTree& tree() { return tab_->tree(); }
    ProgramModel& model() { return *static_cast<ProgramModel*>(tree().model()); }
    const Steps& steps() { return document_->project().programs.at(0).steps; }
    QPushButton* key(const char* name) { return tab_->findChild<QPushButton*>(QLatin1String(name)); }
    void click(const char* name) { QTest::mouseClick(key(name), Qt::LeftButton); }
    QString status() { return tab_->findChild<ElidedLabel*>("program.status")->fullText(); }
    template <class Editor>
    Editor* field(const char* name) {
        return tab_->findChild<Editor*>(QStringLiteral("program.field.%1").arg(QLatin1String(name)));
    }
    static void type(QLineEdit& edit, const QString& text) {
        edit.setFocus();
        edit.selectAll();
        QTest::keyClick(&edit, Qt::Key_Delete);
        QTest::keyClicks(&edit, text);
        QTest::keyClick(&edit, Qt::Key_Return);
    }
    void openTray() {
        project::ProgramList programs;
        programs.append(trayProgram(document_->project()));
        document_->changePrograms(programs, "open");
    }
    void add(const char* kind) {
        Q_EMIT tab_->findChild<StepPalette*>()->stepChosen(newStep(*findStepKind(kind)));
    }
    QString shape() { return shapeOf(steps()); }
    static QString shapeOf(const Steps& steps) {
        QStringList kinds;
        for (const project::ProgramStep& step : steps) {
            kinds << step.kind + (step.steps.empty() ? QString() : '(' + shapeOf(step.steps) + ')');
        }
        return kinds.join(' ');
    }

    std::unique_ptr<UndoableDocument> document_;
    std::unique_ptr<ProgramTab> tab_;
};

QTEST_MAIN(TestProgramTab)
#include "tst_program_tab.moc"
