// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A question or a message inside the panel, where the eye already is: no dialog, nothing is blocked. Esc or
// the second key puts it away.

#include <QFrame>
#include <functional>

class QLabel;
class QPushButton;

namespace tiller {

class NoticeBar : public QFrame {
    Q_OBJECT

public:
    enum class Kind { Question, Warning };

    explicit NoticeBar(QWidget* parent = nullptr);

    /// accept  label of the primary key; empty for a message that only needs to be put away
    void show(Kind kind, const QString& title, const QString& text, const QString& accept = {},
              std::function<void()> accepted = {});
    void dismiss();
    Kind kind() const { return kind_; }
    QString title() const;
    QString text() const;

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    Kind kind_ = Kind::Question;
    QLabel* title_;
    QLabel* text_;
    QPushButton* accept_;
    QPushButton* dismiss_;
    std::function<void()> accepted_;
};

}  // namespace tiller
