// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Connection check before the first connection to a robot. Each condition has one line with green, amber or
// red, a shape, a text, and a suggested action. The report is the same as that of `tiller-cli doctor`.

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

    /// Width of the longest title in this language, for a common column [px].
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
    /// Starts the examination immediately. It runs in a worker thread and is cancelled when the page is
    /// destroyed.
    explicit PreflightPage(const doctor::Patient& patient, QWidget* parent = nullptr);

    bool isFinished() const { return finished_; }
    const doctor::Report& report() const { return report_; }

Q_SIGNALS:
    void finished();
    /// The user wants to connect.
    void connectRequested();

protected:
    void changeEvent(QEvent* event) override;

private:
    void showNote();
    void examine();
    void showFinding(const doctor::Finding& finding);
    void conclude(const doctor::Report& report);
    /// Makes the suggested button the default button. The other button is not emphasized.
    void offer(bool connecting);
    /// Sorts Bad findings first, then those with Attention, each group in its original order.
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
    SerialExecutor worker_;  // last member, because its job posts to this page
};

}  // namespace tiller
