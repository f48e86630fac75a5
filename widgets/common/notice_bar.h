// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A question or message inside a panel, without a dialog. It does not block other input. Esc or the close
// button closes it.

#include <QFrame>
#include <QString>
#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace tiller {

/// A question or a message with up to three buttons.
struct Notice {
    QString title;
    QString text;
    QString accept = {};  ///< label of the primary button; empty for a message that can only be closed
    std::function<void()> accepted = {};
    QString other = {};  ///< label of the second button; empty if there is none
    std::function<void()> otherAccepted = {};
    QString dismiss = {};  ///< label of the close button; empty: Close or Cancel
    /// Identifies the cause for NoticeBar::resolve(). A notice with a cause is shown again after the notices
    /// that replaced it are closed. The next notice replaces a notice without a cause.
    QString cause = {};
};

class NoticeBar : public QFrame {
    Q_OBJECT

public:
    enum class Kind { Question, Warning };

    explicit NoticeBar(QWidget* parent = nullptr);

    /// accept  label of the primary button; empty for a message that can only be closed
    void show(Kind kind, const QString& title, const QString& text, const QString& accept = {},
              std::function<void()> accepted = {});
    void show(Kind kind, const Notice& notice);
    /// Closes the notice. A waiting notice with a cause is shown again.
    void dismiss();
    /// Like dismiss(), but leaves a notice with a cause open.
    void dismissWithoutCause();
    /// Removes the notice of a cause that has been resolved, including a waiting one.
    void resolve(const QString& cause);
    /// Closes a question without a cause after a change of its underlying data, because the answer would have
    /// a different effect than shown. Messages remain.
    void dismissQuestion();
    Kind kind() const { return kind_; }
    QString title() const;
    QString text() const;

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Waiting {
        Kind kind;
        Notice notice;
    };
    void display(Kind kind, const Notice& notice);
    void answer(std::function<void()> Notice::*callback);

    Kind kind_ = Kind::Question;
    Notice notice_;
    std::vector<Waiting> waiting_;  ///< the last element is shown next
    QLabel* title_;
    QLabel* text_;
    QPushButton* accept_;
    QPushButton* other_;
    QPushButton* dismiss_;
};

}  // namespace tiller
