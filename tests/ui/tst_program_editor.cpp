// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Program tab in the real window, with a simulated robot in virtual time: drag and drop, keyboard,
// problems, preview, and stops from each of the controls.

#include <QDialog>
#include <QDragEnterEvent>
#include <QDragMoveEvent>
#include <QDropEvent>
#include <QFile>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>
#include <QUrl>
#include <algorithm>
#include <functional>

#include "app/action_table.h"
#include "program_samples.h"
#include "robot/station/program/program_edit.h"
#include "robot/station/station.h"
#include "tests/support/event_spy.h"
#include "tests/support/window_bench.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/segmented_control.h"
#include "widgets/hold/hold_to_run_button.h"
#include "widgets/log/log_model.h"
#include "widgets/program/program_model.h"
#include "widgets/program/program_tab.h"
#include "widgets/program/step_palette.h"
#include "widgets/program/step_tree.h"
#include "widgets/project/undoable_document.h"
#include "widgets/scene/scene_view.h"

using namespace tiller;
using namespace tiller::test;
using program::Steps;

class TestProgramEditor : public QObject {
    Q_OBJECT

private:
    /// Moves to the start of a program and runs it, with or without hold-to-run.
    void startMoves(bool held) {
        const QString pick = [&] {
            document().setProject(program::sampleProject());
            return program::waypointId(document().project(), "pick");
        }();
        const QString place = program::waypointId(document().project(), "place");
        project::ProgramList programs;
        programs.append(
            program::makeProgram("moves", {program::step("loop", {{"times", 5}},
                                                         {program::step("moveL", {{"waypoint", pick}}),
                                                          program::step("moveL", {{"waypoint", place}})})}));
        document().changePrograms(programs, "open");
        QVERIFY2(cell().bringUp(), qPrintable(cell().what()));
        auto& hold = bench_->find<HoldToRunButton>("program.runHold");
        auto& start = bench_->find<HoldToRunButton>("program.moveToStart");
        for (HoldToRunButton* button : {&hold, &start}) {
            button->guard().setClock(bench_->clock);
        }
        cell().everyRefresh = [&] {
            hold.guard().pump();
            start.guard().pump();
        };
        QTRY_VERIFY_WITH_TIMEOUT(key("program.preview").isEnabled(), 60'000);
        QTest::mouseClick(&key("program.preview"), Qt::LeftButton);
        QTRY_VERIFY2_WITH_TIMEOUT(status().startsWith("Simulated: the program takes"), qPrintable(status()),
                                  60'000);
        cell().advanceMs(40);
        QVERIFY2(start.isEnabled(), qPrintable(start.toolTip()));
        QTest::mousePress(&start, Qt::LeftButton);
        QVERIFY2(cell().advanceUntil([&] { return !start.isHolding(); }, 60'000), qPrintable(status()));
        QTest::mouseRelease(&start, Qt::LeftButton);
        cell().advanceMs(40);
        if (held) {
            QTest::mousePress(&hold, Qt::LeftButton);
        } else {
            QVERIFY2(key("program.run").isEnabled(), qPrintable(key("program.run").toolTip()));
            QTest::mouseClick(&key("program.run"), Qt::LeftButton);
        }
        QVERIFY2(cell().advanceUntil([&] { return tcpSpeed(cell()) > 0.04; }, 60'000), qPrintable(status()));
        QVERIFY2(status().contains("Running step"), qPrintable(status()));
    }

    std::unique_ptr<WindowBench> bench_;

    app::MainWindow& window() { return bench_->window; }
    VirtualCell& cell() { return bench_->cell; }
    UndoableDocument& document() { return window().document(); }
    StepTree& tree() { return bench_->find<StepTree>("program.tree"); }
    StepPalette& palette() { return bench_->find<StepPalette>("program.palette"); }
    QAbstractItemModel& model() { return *tree().model(); }
    const Steps& steps() { return document().project().programs.at(0).steps; }
    QString status() { return bench_->find<ElidedLabel>("program.status").fullText(); }
    QPushButton& key(const char* name) { return bench_->find<QPushButton>(name); }
    QLineEdit& field(const char* name) {
        return bench_->find<QLineEdit>(QByteArray("program.field.").append(name).constData());
    }
    QModelIndex rowOf(const QUuid& id) { return static_cast<ProgramModel&>(model()).indexOf(id); }
    QModelIndex paletteRow(const QString& name) {
        return palette()
            .model()
            ->match(palette().model()->index(0, 0), Qt::DisplayRole, name, 1,
                    Qt::MatchExactly | Qt::MatchRecursive)
            .value(0);
    }
    /// Builds and opens the tray program.
    void openTray() {
        document().setProject(program::sampleProject());
        project::ProgramList programs;
        programs.append(program::trayProgram(document().project()));
        document().changePrograms(programs, "open");
        QCoreApplication::processEvents();
    }
    QString shape() { return document().project().programs.isEmpty() ? QString() : shapeOf(steps()); }
    static QString shapeOf(const Steps& steps) {
        QStringList kinds;
        for (const project::ProgramStep& step : steps) {
            kinds << step.kind + (step.steps.empty() ? QString() : '(' + shapeOf(step.steps) + ')');
        }
        return kinds.join(' ');
    }
    /// Drops the data dragged from these rows, as the drag manager does. With Ctrl, the drop copies.
    void drop(QAbstractItemModel& from, const QModelIndexList& rows, const QPoint& at,
              Qt::DropAction action) {
        const std::unique_ptr<QMimeData> data(from.mimeData(rows));
        const Qt::DropActions possible = Qt::CopyAction | Qt::MoveAction;
        const auto keys = action == Qt::CopyAction ? Qt::ControlModifier : Qt::NoModifier;
        QDragEnterEvent enter(at, possible, data.get(), Qt::LeftButton, keys);
        QApplication::sendEvent(tree().viewport(), &enter);
        QVERIFY(enter.isAccepted());
        QDragMoveEvent move(at, possible, data.get(), Qt::LeftButton, keys);
        move.setDropAction(action);
        QApplication::sendEvent(tree().viewport(), &move);
        QVERIFY(move.isAccepted());
        QDropEvent dropped(at, possible, data.get(), Qt::LeftButton, keys);
        dropped.setDropAction(action);
        QApplication::sendEvent(tree().viewport(), &dropped);
    }
    QDialog* importReport() { return window().findChild<QDialog*>("program.import"); }
    static QString writtenScript(const QTemporaryDir& folder, const QString& name,
                                 const QByteArray& content) {
        QFile file(folder.filePath(name));
        return file.open(QIODevice::WriteOnly) && file.write(content) == content.size() ? file.fileName()
                                                                                        : QString();
    }
    /// Drops a file of a file manager.
    static void dropFile(QWidget& on, const QString& path, bool isAccepted) {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        const QPoint at(5, 5);
        QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(&on, &enter);
        QCOMPARE(enter.isAccepted(), isAccepted);
        if (isAccepted) {
            QDropEvent dropped(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
            QApplication::sendEvent(&on, &dropped);
            QVERIFY(dropped.isAccepted());
        }
    }
    QPoint middleOf(const QModelIndex& row) { return tree().visualRect(row).center(); }
    QPoint topOf(const QModelIndex& row) {
        const QRect place = tree().visualRect(row);
        return {place.center().x(), place.top() + 1};
    }
    QPoint belowAll() { return {40, tree().viewport()->height() - 2}; }

private Q_SLOTS:
    void init() {
        bench_ = std::make_unique<WindowBench>();
        bench_->show(QSize(1920, 1040));
        window().showTab("program");
    }
    void cleanup() { bench_.reset(); }

    void stepsAreDraggedFromThePalette() {
        QCOMPARE(document().project().programs.size(), std::size_t(0));
        drop(*palette().model(), {paletteRow("Loop")}, belowAll(), Qt::CopyAction);
        QCOMPARE(shape(), QString("loop"));
        drop(*palette().model(), {paletteRow("Wait")}, middleOf(rowOf(steps()[0].id)), Qt::CopyAction);
        QCOMPARE(shape(), QString("loop(wait)"));
        drop(*palette().model(), {paletteRow("MoveJ")}, belowAll(), Qt::CopyAction);
        QCOMPARE(shape(), QString("loop(wait) moveJ"));
        // The first drop also added the program, in the same undo step.
        for (int i = 0; i < 3; ++i) {
            document().undo();
        }
        QVERIFY(document().project().programs.isEmpty());
    }

    void stepsAreDraggedInTheTree() {
        openTray();
        drop(model(), {rowOf(steps()[1].id)}, topOf(rowOf(steps()[0].id)), Qt::MoveAction);
        QVERIFY2(shape().startsWith("gripper moveJ assign try"), qPrintable(shape()));
        const QUuid inner = steps()[3].steps[0].id;
        drop(model(), {rowOf(steps()[0].id)}, middleOf(rowOf(inner)), Qt::MoveAction);
        QVERIFY2(shape().startsWith("moveJ assign try(forEachPlace(moveJ moveL gripper"),
                 qPrintable(shape()));
        QVERIFY2(shape().contains("assign gripper))"), qPrintable(shape()));
        drop(model(), {rowOf(steps()[0].id)}, belowAll(), Qt::CopyAction);
        QVERIFY2(
            shape().startsWith("moveJ assign try") && shape().endsWith("onError(gripper log) moveJ moveJ"),
            qPrintable(shape()));
        for (int i = 0; i < 3; ++i) {
            document().undo();
        }
        QVERIFY2(shape().startsWith("moveJ gripper assign try"), qPrintable(shape()));
    }

    // The same program can be built by mouse and by keyboard.
    void aProgramIsBuiltWithTheKeyboard() {
        palette().setCurrentIndex(paletteRow("Loop"));
        palette().setFocus();
        QTest::keyClick(&palette(), Qt::Key_Return);
        palette().setCurrentIndex(paletteRow("Wait"));
        QTest::keyClick(&palette(), Qt::Key_Return);
        palette().setCurrentIndex(paletteRow("Comment"));
        QTest::keyClick(&palette(), Qt::Key_Return);
        QCOMPARE(shape(), QString("loop(wait comment)"));
        tree().setFocus();
        QTest::keyClick(&tree(), Qt::Key_Left, Qt::ControlModifier);
        QCOMPARE(shape(), QString("loop(wait) comment"));
        QTest::keyClick(&tree(), Qt::Key_Up, Qt::ControlModifier);
        QCOMPARE(shape(), QString("comment loop(wait)"));
        QTest::keyClick(&tree(), Qt::Key_Down, Qt::ControlModifier);
        QTest::keyClick(&tree(), Qt::Key_Right, Qt::ControlModifier);
        QCOMPARE(shape(), QString("loop(wait comment)"));
        QTest::keyClick(&tree(), Qt::Key_Up);
        QTest::keyClick(&tree(), Qt::Key_Return);
        QCOMPARE(QApplication::focusWidget(), &field("time"));
        QTest::keyClicks(&field("time"), "7");
        QTest::keyClick(&field("time"), Qt::Key_Escape);
        QVERIFY(!field("time").text().contains('7'));
        field("time").selectAll();
        QTest::keyClicks(&field("time"), "2.5");
        QTest::keyClick(&field("time"), Qt::Key_Return);
        QCOMPARE(steps()[0].steps[0].fields["time"].toDouble(), 2.5);
        tree().setFocus();
        QTest::keyClick(&tree(), Qt::Key_Delete);
        QCOMPARE(shape(), QString("loop(comment)"));
        QTest::keyClick(&tree(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(shape(), QString("loop(wait comment)"));
        QTest::keyClick(&tree(), Qt::Key_Y, Qt::ControlModifier);
        QCOMPARE(shape(), QString("loop(comment)"));
    }

    void problemsAreOneClickAway() {
        openTray();
        QVERIFY(!key("program.showProblem").isVisible());
        project::ProgramList programs = document().project().programs;
        project::Program broken = programs.at(0);
        broken.steps[0].fields.remove("waypoint");
        broken.steps[3].steps[0].fields.remove("pattern");
        programs.replace(0, broken);
        document().changePrograms(programs, "break");
        QTRY_VERIFY_WITH_TIMEOUT(key("program.showProblem").isVisible(), 60'000);
        QVERIFY(!key("program.preview").isEnabled());
        QVERIFY2(status().startsWith("⚠ Step 1:"), qPrintable(status()));
        QTest::mouseClick(&key("program.showProblem"), Qt::LeftButton);
        QCOMPARE(tree().selectedIds(), QSet<QUuid>{steps()[0].id});
        auto& problem = bench_->find<QLabel>("program.problem");
        QVERIFY(problem.isVisible() && status().endsWith(QString(problem.text()).remove("⚠ ")));
        QCOMPARE(QApplication::focusWidget()->objectName(), QString("program.field.waypoint"));
        QTest::mouseClick(&key("program.showProblem"), Qt::LeftButton);
        QCOMPARE(tree().selectedIds(), QSet<QUuid>{steps()[3].steps[0].id});
        QVERIFY(rowOf(steps()[0].id).data().toString().startsWith("⚠"));
        document().undo();
        QTRY_VERIFY_WITH_TIMEOUT(!key("program.showProblem").isVisible(), 60'000);
        QVERIFY(!rowOf(steps()[0].id).data().toString().startsWith("⚠"));
    }

    void disabledStepsAndCommentsAreMarked() {
        openTray();
        tree().selectIds({steps()[1].id});
        tree().setFocus();
        QTest::keyClick(&tree(), Qt::Key_Slash, Qt::ControlModifier);
        QVERIFY(rowOf(steps()[1].id).data(Qt::FontRole).value<QFont>().strikeOut());
        QVERIFY(rowOf(steps()[1].id).data(Qt::AccessibleTextRole).toString().endsWith("disabled"));
        project::ProgramList programs = document().project().programs;
        project::Program program = programs.at(0);
        program.steps.insert(program.steps.begin(),
                             program::step("comment", {{"text", "Empty the tray first"}}));
        programs.replace(0, program);
        document().changePrograms(programs, "comment");
        const QModelIndex comment = rowOf(steps()[0].id);
        QVERIFY(comment.data(Qt::FontRole).value<QFont>().italic());
        QCOMPARE(comment.siblingAtColumn(ProgramModel::Values).data().toString(),
                 QString("Empty the tray first"));
    }

    void namesHaveAllSpaceThatIsLeft_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("smallest") << QSize(1280, 720);
        QTest::newRow("full HD") << QSize(1920, 1040);
    }
    void namesHaveAllSpaceThatIsLeft() {
        QFETCH(QSize, size);
        openTray();
        window().resize(size);
        QTest::qWait(50);
        // A narrow tree leaves the names all space except for the titles of the other columns.
        const QHeaderView& header = *tree().header();
        const int others =
            header.sectionSizeHint(ProgramModel::Values) + header.sectionSizeHint(ProgramModel::Result);
        const int whole = static_cast<QAbstractItemView&>(tree()).sizeHintForColumn(ProgramModel::Step);
        QVERIFY(tree().columnWidth(ProgramModel::Step) >=
                std::min(whole, tree().viewport()->width() - others));
        QVERIFY(tree().viewport()->width() >= 150);
    }

    // In a narrow panel, either the palette or the fields are shown, and the tree keeps its position.
    void aNarrowPanelShowsOneSide() {
        openTray();
        window().resize(1280, 720);
        QTest::qWait(50);
        auto& side = bench_->find<SegmentedControl>("program.side");
        QVERIFY(side.isVisible() && palette().isVisible());
        const QRect before = tree().geometry();
        tree().selectIds({steps()[0].id});
        side.setCurrentIndex(1);
        QTest::qWait(10);
        QVERIFY(!palette().isVisible() && bench_->find<QWidget>("program.form").isVisible());
        QCOMPARE(tree().geometry(), before);
    }

    void previewShowsStepsAndPath() {
        openTray();
        QVERIFY2(cell().bringUp(), qPrintable(cell().what()));
        const JointPositions before = cell().truth().q;
        QTRY_VERIFY_WITH_TIMEOUT(key("program.preview").isEnabled(), 60'000);
        QTest::mouseClick(&key("program.preview"), Qt::LeftButton);
        QCOMPARE(status(), QString("Simulating…"));  // the window was not blocked
        QTRY_VERIFY2_WITH_TIMEOUT(status().startsWith("Simulated: the program takes"), qPrintable(status()),
                                  60'000);
        const QModelIndex inner = rowOf(steps()[3].steps[0].steps[1].id);
        QVERIFY2(inner.siblingAtColumn(ProgramModel::Result).data().toString().startsWith("1 ×"),
                 qPrintable(inner.siblingAtColumn(ProgramModel::Result).data().toString()));
        const SceneView& view = *window().findChild<SceneView*>();
        QCOMPARE(view.paths().size(), std::size_t(1));
        QVERIFY(view.paths()[0].kind == PathMark::Kind::Coming && view.paths()[0].places.size() > 20);
        window().showTab("log");
        QVERIFY(view.paths().empty());
        window().showTab("program");
        QCOMPARE(view.paths().size(), std::size_t(1));
        document().undo();
        QTRY_VERIFY_WITH_TIMEOUT(view.paths().empty(), 60'000);
        cell().advanceMs(500);
        QVERIFY((cell().truth().q.values - before.values).cwiseAbs().maxCoeff() < 1e-9);
    }

    // A file dropped on any part of the tab becomes a program. One undo step removes it with its waypoints.
    void droppedFileBecomesAProgram() {
        openTray();
        const project::Project before = document().project();
        const QTemporaryDir folder;
        const QString path = writtenScript(folder, "pick.script",
                                           "def pick():\n  movej([0, -1.5, 1.5, 0, 1, 0])\n  "
                                           "zero_ftsensor()\n  if get_standard_digital_in(1):\n"
                                           "    sleep(1)\n  end\nend\n");
        dropFile(*tree().viewport(), path, true);
        QTRY_VERIFY2_WITH_TIMEOUT(importReport() != nullptr, qPrintable(status()), 60'000);
        QCOMPARE(document().project().programs.size(), std::size_t(2));
        QCOMPARE(shapeOf(document().project().programs.at(1).steps), QString("moveJ script if(wait)"));
        QCOMPARE(document().waypoints().size(), before.waypoints.size() + 1);
        QCOMPARE(bench_->find<QComboBox>("program.choice").currentText(), QString("pick"));
        QCOMPARE(importReport()->findChild<QLabel*>("program.import.summary")->text(),
                 QString("Steps: 3. Kept as URScript text: 1. Not imported: 0. New waypoints: 1."));
        auto& rows = *importReport()->findChild<QTreeWidget*>("program.import.rows");
        QStringList results;
        for (int row = 0; row < rows.topLevelItemCount(); ++row) {
            const QTreeWidgetItem& item = *rows.topLevelItem(row);
            results << item.text(0) + ": " + item.text(2);
        }
        QCOMPARE(results,
                 QStringList({"2: 1  MoveJ", "3: ⚠ 2  URScript (no step corresponds to this statement)",
                              "4: 3  If", "5: 4  Wait"}));
        // Enter selects the step of the row.
        rows.setCurrentItem(rows.topLevelItem(3));
        QTest::keyClick(&rows, Qt::Key_Return);
        QCOMPARE(tree().selectedIds(), QSet<QUuid>{document().project().programs.at(1).steps[2].steps[0].id});
        importReport()->close();
        document().undo();
        QVERIFY(document().project() == before);
        document().redo();
        QCOMPARE(document().project().programs.size(), std::size_t(2));
        // The same file again is a program with another name.
        dropFile(*tree().viewport(), path, true);
        QTRY_COMPARE_WITH_TIMEOUT(document().project().programs.size(), std::size_t(3), 60'000);
        QCOMPARE(document().project().programs.at(2).name, QString("pick 2"));
    }

    // The project may change while a file is imported.
    void editDuringAnImportIsKept() {
        openTray();
        const QTemporaryDir folder;
        dropFile(*tree().viewport(), writtenScript(folder, "a.script", "sleep(1)\n"), true);
        project::ProgramList programs = document().project().programs;
        programs.append(program::makeProgram("other", {program::step("wait", {{"time", 1}})}));
        document().changePrograms(programs, "add");
        QTRY_VERIFY2_WITH_TIMEOUT(importReport() != nullptr, qPrintable(status()), 60'000);
        QStringList names;
        for (const project::Program& program : document().project().programs) {
            names << program.name;
        }
        QCOMPARE(names, QStringList({programs.at(0).name, "other", "a"}));
    }

    void failedImportReportsCauseAndAction_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("cause");
        QTest::addColumn<QString>("action");
        QTest::newRow("open block") << "a.script" << QByteArray("def a():\n  while True:\n")
                                    << "a.script: line 4: the block that begins on line 2 has no end"
                                    << "repair the file";
        QTest::newRow("not a program") << "a.urp" << QByteArray("<Installation/>") << "a.urp: "
                                       << "Save the program on the teach pendant";
        QTest::newRow("no file") << "a.script" << QByteArray() << "a.script"
                                 << "Check that the file exists";
    }
    void failedImportReportsCauseAndAction() {
        QFETCH(QString, file);
        QFETCH(QByteArray, content);
        QFETCH(QString, cause);
        QFETCH(QString, action);
        openTray();
        const project::Project before = document().project();
        const QTemporaryDir folder;
        const QString path = writtenScript(folder, file, content);
        if (content.isEmpty()) {
            QVERIFY(QFile::remove(path));
        }
        dropFile(*tree().viewport(), path, true);
        QMessageBox* box = nullptr;
        QTRY_VERIFY_WITH_TIMEOUT((box = window().findChild<QMessageBox*>("program.importError")) != nullptr,
                                 60'000);
        QVERIFY2(box->text().contains(cause) && box->text().contains(action), qPrintable(box->text()));
        QVERIFY(document().project() == before);
        QVERIFY2(status().contains("The import failed"), qPrintable(status()));
        box->close();
    }

    void otherFilesAreNotImported() {
        openTray();
        const QTemporaryDir folder;
        dropFile(*tree().viewport(), writtenScript(folder, "picture.png", "x"), false);
    }

    void previewNamesTheFirstProblem() {
        openTray();
        project::ProgramList programs = document().project().programs;
        project::Program program = programs.at(0);
        program.steps.insert(program.steps.begin() + 1, program::step("fail", {{"text", "No tray"}}));
        programs.replace(0, program);
        document().changePrograms(programs, "fail");
        QTRY_VERIFY_WITH_TIMEOUT(key("program.preview").isEnabled(), 60'000);
        QTest::mouseClick(&key("program.preview"), Qt::LeftButton);
        QTRY_VERIFY2_WITH_TIMEOUT(status().contains("Simulated: 1 problem"), qPrintable(status()), 60'000);
        QVERIFY2(status().contains("Step 2 (Fail)"), qPrintable(status()));
        QTest::mouseClick(&key("program.showProblem"), Qt::LeftButton);
        QCOMPARE(tree().selectedIds(), QSet<QUuid>{steps()[1].id});
    }

    // An endless program is simulated for one hour of program time. An edit ends the simulation immediately.
    void anEditEndsThePreview() {
        document().setProject(program::sampleProject());
        project::ProgramList programs;
        programs.append(program::makeProgram(
            "endless", {program::step("loop", {{"times", 0}}, {program::step("wait", {{"time", 1}})})}));
        programs.append(program::makeProgram("short", {program::step("wait", {{"time", 1}})}));
        document().changePrograms(programs, "open");
        QTRY_VERIFY2_WITH_TIMEOUT(key("program.preview").isEnabled(), qPrintable(status()), 60'000);
        QTest::mouseClick(&key("program.preview"), Qt::LeftButton);
        QCOMPARE(status(), QString("Simulating…"));
        project::Program changed = programs.at(0);
        changed.steps[0].steps[0].fields["time"] = 2;
        programs.replace(0, changed);
        document().changePrograms(programs, "change");
        QTRY_VERIFY2_WITH_TIMEOUT(status().startsWith("The program can run"), qPrintable(status()), 60'000);
    }

    // Every input that stops the arm also stops a running program, and the arm stays at standstill.
    void everyStopInputStopsAProgram_data() {
        QTest::addColumn<bool>("held");
        QTest::addColumn<QString>("way");
        for (const char* way : {"Space", "Esc", "STOP", "release control", "close"}) {
            QTest::addRow("%s, held", way) << true << QString(way);
            QTest::addRow("%s, running", way) << false << QString(way);
        }
        for (const char* way : {"release", "other tab", "dialog"}) {
            QTest::addRow("%s, held", way) << true << QString(way);
        }
    }
    void everyStopInputStopsAProgram() {
        QFETCH(bool, held);
        QFETCH(QString, way);
        startMoves(held);
        if (QTest::currentTestFailed()) {
            return;
        }
        QDialog dialog(&window());
        if (way == "Space" || way == "Esc") {
            QTest::keyPress(QApplication::focusWidget(), way == "Esc" ? Qt::Key_Escape : Qt::Key_Space);
        } else if (way == "STOP") {
            QTest::mousePress(&bench_->find<QAbstractButton>("stopButton"), Qt::LeftButton);
        } else if (way == "release control") {
            window().session().releaseControl();
        } else if (way == "close") {
            window().session().shutDown();
        } else if (way == "release") {
            QTest::mouseRelease(&bench_->find<HoldToRunButton>("program.runHold"), Qt::LeftButton);
        } else if (way == "other tab") {
            window().showTab("log");
        } else {
            dialog.show();
            QCoreApplication::processEvents();
        }
        const int ms = timeToStandstill(cell());
        QVERIFY2(ms >= 0 && ms <= 250, qPrintable(QString::number(ms)));
        cell().advanceMs(1000);
        QVERIFY(tcpSpeed(cell()) < 0.001);
        QVERIFY2(way == "close" || status().startsWith("Stopped in step"), qPrintable(status()));
    }

    // The log contains the first run of each step; the lane of the plots and recordings contain every run.
    void stepsAreInTheLogTheLaneAndRecordings() {
        startMoves(false);
        if (QTest::currentTestFailed()) {
            return;
        }
        const QString path = bench_->folder.filePath("run.csv");
        const test::EventSpy began(window().session().journal(), JournalEvent::Kind::Step);
        window().session().recording().start(path);
        QVERIFY(cell().advanceUntil([&] { return window().session().state().recording.active; }, 60'000));
        QVERIFY(cell().advanceUntil([&] { return began.count() >= 4; }, 60'000));
        window().session().stop(control::StopCause::StopButton);
        cell().advanceMs(1000);
        window().session().recording().stop();
        QVERIFY(cell().advanceUntil([&] { return !window().session().state().recording.active; }, 60'000));

        const auto* log = window().findChild<LogModel*>();
        QStringList steps;
        for (int row = log->rowCount() - 1; row >= 0; --row) {  // the newest entry is the first one
            const QString text = log->index(row, LogModel::Text).data().toString();
            steps << (text.startsWith("Step ") ? QStringList(text) : QStringList());
        }
        // Step 1, the loop itself, is shorter than the period of the packets.
        QCOMPARE(steps, QStringList({"Step 2 (MoveL)", "Step 3 (MoveL)"}));

        QStringList labels;
        for (const LaneSegment& segment : window().station().history().lane().segments()) {
            labels << segment.label;
        }
        QVERIFY2(labels.count("Step 2 (MoveL)") >= 2, qPrintable(labels.join(", ")));
        QVERIFY2(labels.contains("Step 3 (MoveL)"), qPrintable(labels.join(", ")));
        QCOMPARE(labels.last(), QString("At standstill"));

        QFile notes(bench_->folder.filePath("run.notes.csv"));
        QVERIFY(notes.open(QIODevice::ReadOnly));
        const QString recorded = QString::fromUtf8(notes.readAll());
        QVERIFY2(recorded.contains("Step 2 (MoveL)") && recorded.contains("Step 3 (MoveL)"),
                 qPrintable(recorded));
        QVERIFY2(recorded.count("Step ") >= 3, qPrintable(recorded));
    }

    // Switching the tab or opening a dialog ends held motions, but not a program that runs without a held
    // button.
    void aProgramThatRunsByItselfContinues_data() {
        QTest::addColumn<QString>("event");
        for (const char* event : {"other tab", "dialog", "settings"}) {
            QTest::newRow(event) << QString(event);
        }
    }
    void aProgramThatRunsByItselfContinues() {
        QFETCH(QString, event);
        startMoves(false);
        if (QTest::currentTestFailed()) {
            return;
        }
        QDialog dialog(&window());
        if (event == "other tab") {
            window().showTab("log");
        } else if (event == "dialog") {
            dialog.show();
            QCoreApplication::processEvents();
        } else {
            window().actions().find("app.settings")->trigger();
        }
        cell().advanceMs(500);
        QVERIFY2(cell().advanceUntil([&] { return tcpSpeed(cell()) > 0.04; }, 20'000), "the program ended");
        QVERIFY2(status().contains("Running step"), qPrintable(status()));
        window().session().stop(control::StopCause::StopButton);
        const int ms = timeToStandstill(cell());
        QVERIFY2(ms >= 0 && ms <= 250, qPrintable(QString::number(ms)));
    }

    void noProjectIsOpenedWhileAProgramRuns() {
        const QString file = bench_->folder.filePath("other.tiller");
        QVERIFY(project::saveProject(file, {}).ok());
        startMoves(false);
        if (QTest::currentTestFailed()) {
            return;
        }
        QStringList log;
        const QObject listener;  // disconnects before the end of the log's lifetime
        test::onMessage(window().session().journal(), &listener,
                        [&](Severity, const QString& text) { log << text; });
        window().openProject(file);
        QCOMPARE(document().project().programs.size(), std::size_t(1));
        QVERIFY2(log.join(' ').contains("A program is running"), qPrintable(log.join('\n')));
        log.clear();
        window().actions().find("project.open")->trigger();
        QVERIFY2(log.join(' ').contains("A program is running"), qPrintable(log.join('\n')));
        QVERIFY2(cell().advanceUntil([&] { return tcpSpeed(cell()) > 0.04; }, 20'000), "the program ended");
        window().session().stop(control::StopCause::StopButton);
        QVERIFY(cell().advanceUntil([&] { return status().startsWith("Stopped in step"); }, 20'000));
        window().openProject(file);
        QVERIFY(document().project().programs.isEmpty());
    }

    // Each control of the tab gets the focus once. Space and Esc must stop the arm, like STOP.
    void everyControlStopsTheArm_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("stopKey");
        for (const char* name : {"program.tree", "program.palette", "program.field.time", "program.preview",
                                 "program.choice", "program.more"}) {
            QTest::newRow(qPrintable(QStringLiteral("%1 Space").arg(name)))
                << QString(name) << int(Qt::Key_Space);
            QTest::newRow(qPrintable(QStringLiteral("%1 Esc").arg(name)))
                << QString(name) << int(Qt::Key_Escape);
        }
    }
    void everyControlStopsTheArm() {
        QFETCH(QString, name);
        QFETCH(int, stopKey);
        openTray();
        QVERIFY2(cell().bringUp(), qPrintable(cell().what()));
        tree().selectIds({steps()[1].id});
        QTRY_VERIFY_WITH_TIMEOUT(key("program.preview").isEnabled(), 60'000);
        auto& control = bench_->find<QWidget>(qPrintable(name));
        control.setFocus();
        QCOMPARE(QApplication::focusWidget(), &control);
        control::JogTarget target;
        target.twist.linear.z() = 0.05;
        const auto jog = window().session().beginJog(target);
        QVERIFY(jog.ok());
        cell().everyRefresh = [&] { window().session().hold(*jog); };
        cell().advanceMs(300);
        QVERIFY(tcpSpeed(cell()) > 0.02);
        QTest::keyPress(&control, static_cast<Qt::Key>(stopKey));
        QVERIFY(!window().session().hold(*jog));
        const int ms = timeToStandstill(cell());
        QVERIFY2(ms >= 0 && ms <= 100, qPrintable(QString::number(ms)));
        QTest::keyRelease(&control, static_cast<Qt::Key>(stopKey));
    }
};

QTEST_MAIN(TestProgramEditor)
#include "tst_program_editor.moc"
