// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A text with a check mark for a completed item. Position and size do not depend on the state.

#include <QWidget>

class QLabel;

namespace tiller {

class ChecklistItem : public QWidget {
    Q_OBJECT

public:
    explicit ChecklistItem(const QString& text, QWidget* parent = nullptr);

    void setText(const QString& text);
    QString text() const;
    void setDone(bool done);
    bool isDone() const { return done_; }
    void reserveLines(int lines);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void describe();

    QLabel* text_;
    bool done_ = false;
};

}  // namespace tiller
