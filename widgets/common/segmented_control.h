// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A row of joined buttons, exactly one of which is selected, e.g. frame, motion, speed. The mouse wheel does
// not change the selection. Each button is a QAbstractButton named "<name of the control>.<index>".

#include <QStringList>
#include <QVector>
#include <QWidget>

class QAbstractButton;
class QButtonGroup;
class QHBoxLayout;

namespace tiller {

class SegmentedControl : public QWidget {
    Q_OBJECT

public:
    explicit SegmentedControl(const QStringList& labels, QWidget* parent = nullptr);

    int count() const { return static_cast<int>(segments_.size()); }
    int currentIndex() const { return current_; }
    /// Selects a segment, even if it is disabled. Emits currentChanged() if the selection changes. An invalid
    /// index is ignored.
    void setCurrentIndex(int index);
    QString text(int index) const;
    void setText(int index, const QString& text);
    /// Reserves the width of the longest text for the segment, so that the other segments do not move.
    void reserve(int index, const QString& widest);
    /// reason  tooltip while the segment is disabled
    void setSegmentEnabled(int index, bool enabled, const QString& reason = {});
    QAbstractButton* segment(int index) const;
    /// Sets the names of the control and its buttons for tests and screen readers.
    void setNames(const QString& objectName, const QString& accessibleName);

Q_SIGNALS:
    /// The user or setCurrentIndex() selected a different segment.
    void currentChanged(int index);

private:
    void nameSegment(int index);

    QVector<QAbstractButton*> segments_;
    QHBoxLayout* layout_;
    QButtonGroup* group_;
    int current_ = 0;
};

}  // namespace tiller
