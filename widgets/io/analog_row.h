// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A row for an analog input or output: terminal, name, value in mA or V, and the value in the user's unit.
// Setting an output always includes its domain.

#include <QString>
#include <QWidget>

#include "robot/io/outputs.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace tiller {

class DecimalSpinBox;

/// Values in the user's unit at both ends of the electrical range. An empty unit means no scaling.
struct AnalogScale {
    double low = 0;
    double high = 10;
    QString unit;

    bool isSet() const { return !unit.isEmpty(); }
    /// level  position in the range, 0 ... 1
    double at(double level) const { return low + level * (high - low); }
    /// Text form, e.g. "0|10|bar".
    QString toText() const;
    static AnalogScale fromText(const QString& text);
};

class AnalogRow : public QWidget {
    Q_OBJECT

public:
    using Domain = io::AnalogDomain;

    /// terminal  e.g. "AI 0"
    AnalogRow(const QString& terminal, bool output, QWidget* parent = nullptr);

    QString terminal() const { return terminal_; }
    QString name() const { return name_; }
    void setName(const QString& name);
    const AnalogScale& scale() const { return scale_; }
    void setScale(const AnalogScale& scale);
    /// value  reported by the robot [mA or V]
    void setValue(double value, Domain domain, bool valid, bool stale);
    /// Sets the reason why the output cannot be set; empty if it can be set.
    void setObstacle(const QString& why);
    /// The displayed value, e.g. "12.00 mA · 5.0 bar".
    QString valueText() const;
    /// Opens the dialog for editing the name.
    void askForName();

    /// Minimum and maximum of a domain [mA or V].
    static double lowest(Domain domain) { return domain == Domain::Current ? 4 : 0; }
    static double highest(Domain domain) { return domain == Domain::Current ? 20 : 10; }

Q_SIGNALS:
    /// The user changed the name or the scale.
    void changed();
    /// level  position in the range of the domain, 0 ... 1
    void setRequested(tiller::io::AnalogDomain domain, double level);

protected:
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void askForScale();
    void describe();
    Domain wantedDomain() const;

    QString terminal_;
    QString name_;
    AnalogScale scale_;
    bool output_;
    QLabel* nameLabel_;
    QLabel* valueLabel_;
    QComboBox* domain_ = nullptr;
    DecimalSpinBox* wanted_ = nullptr;
    QPushButton* set_ = nullptr;
};

}  // namespace tiller
