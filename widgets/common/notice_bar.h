// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A question or a message inside the panel, where the eye already is: no dialog, nothing is blocked. Esc or
// the second key puts it away.

#include <QFrame>
#include <QString>
#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace tiller {

/// A question or a message with up to three answers.
struct Notice {
    QString title;
    QString text;
    QString accept = {};  ///< label of the primary key; empty for a message that only needs to be closed
    std::function<void()> accepted = {};
    QString other = {};  ///< label of the second key; empty for none
    std::function<void()> otherAccepted = {};
    QString dismiss = {};  ///< label of the key that closes the notice; empty: Close or Cancel
    /// What the notice is about, for NoticeBar::resolve(). Notices with a cause wait until those shown over them are
    /// closed; one without is replaced by the next.
    QString cause = {};
};

class NoticeBar : public QFrame {
    Q_OBJECT

public:
    enum class Kind { Question, Warning };

    explicit NoticeBar(QWidget* parent = nullptr);

    /// accept  label of the primary key; empty for a message that only needs to be put away
    void show(Kind kind, const QString& title, const QString& text, const QString& accept = {},
              std::function<void()> accepted = {});
    void show(Kind kind, const Notice& notice);
    /// Closes the notice. One that waits with a cause is shown again.
    void dismiss();
    /// As dismiss(), but a notice with a cause remains.
    void dismissWithoutCause();
    /// The cause is gone: removes its notice, also one that waits.
    void resolve(const QString& cause);
    /// What the notice was computed from has changed: closes a question without a cause. Its answer would do something
    /// other than what it shows. Messages remain.
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
    std::vector<Waiting> waiting_;  ///< the one to be shown next is the last
    QLabel* title_;
    QLabel* text_;
    QPushButton* accept_;
    QPushButton* other_;
    QPushButton* dismiss_;
};

}  // namespace tiller
