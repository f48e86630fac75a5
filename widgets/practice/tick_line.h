// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A line of words with a mark before it that says whether it is done. It keeps its place and its size.

#include <QWidget>

class QLabel;

namespace tiller {

class TickLine : public QWidget {
    Q_OBJECT

public:
    explicit TickLine(const QString& text, QWidget* parent = nullptr);

    void setText(const QString& text);
    QString text() const;
    void setDone(bool done);
    bool isDone() const { return done_; }
    /// Room for so many lines of words, whatever they are.
    void reserveLines(int lines);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void describe();

    QLabel* text_;
    bool done_ = false;
};

}  // namespace tiller
