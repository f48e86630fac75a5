// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Searchable list of the recordings in a folder, with date, robot, duration, metadata, notes and a small
// picture of the force. The files are read in the background.

#include <QDialog>
#include <QHash>

#include "robot/recording/formats/recording_overview.h"
#include "robot/station/executor/serial_executor.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace tiller {

class EmptyState;

class RecordingsDialog : public QDialog {
    Q_OBJECT

public:
    explicit RecordingsDialog(const QString& folder, QWidget* parent = nullptr);

    /// Reads the folder again. Files that have not changed are not read again.
    void refresh();
    void setFolder(const QString& folder);

Q_SIGNALS:
    /// The user wants to open a recording.
    void recordingWanted(const QString& path);

private:
    enum Column { Picture, Date, Name, Robot, Duration, Metadata, Notes, kColumns };
    /// Content of a row; read again if the file has changed.
    struct Known {
        qint64 size = 0;
        QDateTime changed;
        recording::RecordingOverview overview;
        QString problem;  ///< why the file cannot be read; empty: it was read
    };

    void readNext();
    void fill(int row, const Known& known);
    void showFile(const QString& path, const Known& known);
    void filter();
    void openCurrent();
    void askForFolder();
    void showCount();

    QString folder_;
    int turn_ = 0;         ///< number of calls of refresh(); the results of jobs started by earlier calls are
                           ///< ignored
    QStringList waiting_;  ///< files that have not been read yet
    QHash<QString, Known> known_;
    QLabel* place_;
    QLineEdit* search_;
    QTableWidget* table_;
    EmptyState* nothing_;
    QLabel* count_;
    QPushButton* open_;
    SerialExecutor files_;  // last member, so that its jobs end before the other members are destroyed
};

}  // namespace tiller
