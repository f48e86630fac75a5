// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Form for the metadata of recordings, such as the operator and the sample. The names of the fields are a
// template for all recordings.

#include <QDialog>
#include <QStringList>

class QCheckBox;
class QLabel;
class QTableWidget;

namespace tiller {

class MetadataDialog : public QDialog {
    Q_OBJECT

public:
    enum class Purpose {
        Edit,
        Record,  ///< the dialog starts a recording
    };
    /// fields  as RecordingChoice::metadata
    /// asks    initial state of the check box
    MetadataDialog(const QStringList& fields, bool asks, Purpose purpose, QWidget* parent = nullptr);

    /// As RecordingChoice::metadata, without rows that have neither a name nor a value.
    QStringList fields() const;
    bool asksBeforeRecording() const;

    void accept() override;

private:
    void addRow(const QString& name, const QString& value);
    void removeRow();
    QString cell(int row, int column) const;
    /// The first error, as a sentence; empty if all rows are valid.
    QString problem(int* row) const;

    QTableWidget* table_;
    QLabel* problem_;
    QCheckBox* asks_;
};

}  // namespace tiller
