// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Asks how to read a table of another program whose time cannot be determined with certainty. Shows the first
// lines of the file.

#include <QDialog>

#include "robot/recording/table_format.h"

namespace tiller {

class ChoiceBox;
class DecimalSpinBox;

class OpenTableDialog : public QDialog {
    Q_OBJECT

public:
    /// format  the previous choice
    /// reason  why the table cannot be read with this format
    OpenTableDialog(const QString& path, const recording::TableFormat& format, const QString& reason,
                    QWidget* parent = nullptr);

    recording::TableFormat format() const;
    /// The first line of a text file with column names; empty for other files.
    static QString headerOf(const QString& path);

private:
    ChoiceBox* box(const char* name, const QString& text);
    QStringList columnNames() const;
    void listColumns();

    QStringList lines_;  ///< the first lines of the file
    ChoiceBox* time_;
    ChoiceBox* unit_;
    DecimalSpinBox* rate_;
    ChoiceBox* separator_;
    ChoiceBox* decimal_;
    ChoiceBox* header_;
};

}  // namespace tiller
