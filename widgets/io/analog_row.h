// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One analog input or output as a row: terminal, name, what it carries in mA or V, and what that means in the
// unit of whatever is connected to it. An output is set with its domain, never without.

#include <QString>
#include <QWidget>

#include "robot/io/outputs.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace tiller {

class FigureBox;

/// What the ends of the electrical range mean. Without a unit: not scaled.
struct AnalogScale {
    double low = 0;
    double high = 10;
    QString unit;

    bool isSet() const { return !unit.isEmpty(); }
    /// level  0 ... 1 of the range
    double at(double level) const { return low + level * (high - low); }
    /// "0|10|bar"
    QString toText() const;
    static AnalogScale fromText(const QString& text);
};

class AnalogRow : public QWidget {
    Q_OBJECT

public:
    using Domain = io::AnalogDomain;

    /// terminal  "AI 0"
    AnalogRow(const QString& terminal, bool output, QWidget* parent = nullptr);

    QString terminal() const { return terminal_; }
    QString name() const { return name_; }
    void setName(const QString& name);
    const AnalogScale& scale() const { return scale_; }
    void setScale(const AnalogScale& scale);
    /// value  as the robot reports it [mA or V]
    void setValue(double value, Domain domain, bool valid, bool stale);
    /// Why the output cannot be set; empty when it can.
    void setObstacle(const QString& why);
    /// "12.00 mA · 5.0 bar"
    QString valueText() const;
    /// Opens the question for the name.
    void askForName();

    /// The ends of a domain's range [mA or V].
    static double lowest(Domain domain) { return domain == Domain::Current ? 4 : 0; }
    static double highest(Domain domain) { return domain == Domain::Current ? 20 : 10; }

Q_SIGNALS:
    /// Name or scale were changed by hand.
    void changed();
    /// level  0 ... 1 of the domain's range
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
    FigureBox* wanted_ = nullptr;
    QPushButton* set_ = nullptr;
};

}  // namespace tiller
