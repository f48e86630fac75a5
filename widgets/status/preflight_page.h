// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Checks the connection before the first connection to a robot. Each condition has a line with a shape in
// green, amber or red, a text, and a suggested action. `tiller-cli doctor` shows the same report.

#include <QDialog>
#include <QVector>

#include "robot/doctor/examination.h"
#include "robot/station/executor/serial_executor.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace tiller {

/// One condition with its symbol, finding and suggested action.
class FindingRow : public QWidget {
    Q_OBJECT

public:
    explicit FindingRow(doctor::Condition condition, QWidget* parent = nullptr);

    void showFinding(const doctor::Finding& finding);
    void showWaiting();
    const doctor::Finding& finding() const { return finding_; }

private:
    class Sign;

    /// Width of the longest title in the current language, for a common column width [px].
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
    /// Starts the examination immediately in a worker thread. Destroying the page cancels it.
    explicit PreflightPage(const doctor::Patient& patient, QWidget* parent = nullptr);

    bool isFinished() const { return finished_; }
    const doctor::Report& report() const { return report_; }

Q_SIGNALS:
    void finished();
    void connectRequested();

protected:
    void changeEvent(QEvent* event) override;

private:
    void showNote();
    void examine();
    void showFinding(const doctor::Finding& finding);
    void conclude(const doctor::Report& report);
    /// Makes "Connect" or "Check again" the emphasized default button.
    void offer(bool connecting);
    /// Sorts the findings by severity: Bad, then Attention, then the others. Each group keeps its original
    /// order.
    void sortRows();

    doctor::Patient patient_;
    doctor::Report report_;
    bool finished_ = false;
    std::uint64_t run_ = 0;  ///< number of the current run; findings of earlier runs are ignored

    QVector<FindingRow*> rows_;
    QLabel* summary_;
    QLabel* note_ = nullptr;
    QLabel* consequence_;
    QVBoxLayout* list_;
    QPushButton* again_;
    QPushButton* connect_;
    SerialExecutor worker_;  // last member, so that it is destroyed before the members used by its job
};

}  // namespace tiller
