// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A row of joined keys of which exactly one is chosen: frame, motion, speed. The wheel never changes it.
// Each key is a QAbstractButton named "<name of the control>.<index>".

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
    /// Chooses and tells, also for a key that is disabled; out of range is ignored.
    void setCurrentIndex(int index);
    QString text(int index) const;
    void setText(int index, const QString& text);
    /// Room for the widest text the segment will have: the others keep their places.
    void reserve(int index, const QString& widest);
    /// reason  tooltip that says why, when disabled
    void setSegmentEnabled(int index, bool enabled, const QString& reason = {});
    QAbstractButton* segment(int index) const;
    /// Names the control and its keys, for tests and for screen readers.
    void setNames(const QString& objectName, const QString& accessibleName);

Q_SIGNALS:
    /// Another key was chosen, by hand or by setCurrentIndex().
    void currentChanged(int index);

private:
    void nameSegment(int index);

    QVector<QAbstractButton*> segments_;
    QHBoxLayout* layout_;
    QButtonGroup* group_;
    int current_ = 0;
};

}  // namespace tiller
