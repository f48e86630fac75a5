// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Before the first connection to a robot: one line a condition, green, amber or red with a shape and a word,
// and how to put it right. The same report as `tiller-cli doctor`.

#include <QDialog>
#include <QVector>

#include "robot/doctor/examination.h"
#include "robot/station/executor/serial_executor.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace tiller {

/// One condition with its sign, what was found, and the fix below it.
class FindingRow : public QWidget {
    Q_OBJECT

public:
    explicit FindingRow(doctor::Condition condition, QWidget* parent = nullptr);

    void showFinding(const doctor::Finding& finding);
    void showWaiting();
    const doctor::Finding& finding() const { return finding_; }

private:
    class Sign;

    /// Of all conditions in this language, so that what was found stands in one column [px].
    int widestTitle() const;

    doctor::Finding finding_;
    Sign* sign_;
    QLabel* title_;
    QLabel* detail_;
    QLabel* fix_;
};

class PreflightPage : public QDialog {
    Q_OBJECT

public:
    /// Begins at once. The examination runs on a thread of its own and is cancelled when the page goes.
    explicit PreflightPage(const doctor::Patient& patient, QWidget* parent = nullptr);

    bool isFinished() const { return finished_; }
    const doctor::Report& report() const { return report_; }

Q_SIGNALS:
    void finished();
    /// The operator wants to be connected.
    void connectRequested();

protected:
    void changeEvent(QEvent* event) override;

private:
    void showNote();
    void examine();
    void showFinding(const doctor::Finding& finding);
    void conclude(const doctor::Report& report);
    /// The first thing to do is the dark key and the one for Return; the other is plain.
    void offer(bool connecting);
    /// Bad findings first, then those to look at; each group as examined.
    void sortRows();

    doctor::Patient patient_;
    doctor::Report report_;
    bool finished_ = false;
    std::uint64_t run_ = 0;  ///< findings of an earlier run are dropped

    QVector<FindingRow*> rows_;
    QLabel* summary_;
    QLabel* note_ = nullptr;
    QLabel* consequence_;
    QVBoxLayout* list_;
    QPushButton* again_;
    QPushButton* connect_;
    SerialExecutor worker_;  // last: its job posts to this page
};

}  // namespace tiller
