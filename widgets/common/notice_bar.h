// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A question or message inside a panel instead of a dialog. It does not block other input. Esc or the close
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
    QString text = {};
    QString accept = {};  ///< label of the primary button; empty for a message that can only be closed
    std::function<void()> accepted = {};
    QString other = {};  ///< label of the second button; empty if there is none
    std::function<void()> otherAccepted = {};
    QString dismiss = {};  ///< label of the close button; if empty, "Close" or "Cancel"
    /// Identifies the cause for NoticeBar::resolve(). If another notice replaces a notice with a cause, the
    /// replaced notice is shown again afterwards. A notice without a cause is discarded when it is replaced.
    QString cause = {};
    /// Returns the current text of a question that depends on the position of the arm; see
    /// NoticeBar::refresh().
    std::function<QString()> liveText = {};
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
    /// Closes the notice. If a notice with a cause is waiting, it is shown again.
    void dismiss();
    /// Like dismiss(), but keeps a notice with a cause open.
    void dismissWithoutCause();
    /// Removes the notice with this cause, including a waiting one. Call this when the cause has been
    /// resolved.
    void resolve(const QString& cause);
    /// Closes a question that has no cause. Call this if the data have changed, because accepting the
    /// question would then have a different effect than shown. Messages remain open.
    void dismissQuestion();
    /// Updates the text of a notice with Notice::liveText. Call this regularly with new robot data.
    void refresh();
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
    void setText(const QString& text);
    void answer(std::function<void()> Notice::*callback);

    Kind kind_ = Kind::Question;
    Notice notice_;
    std::vector<Waiting> waiting_;  ///< notices to show again; the last element is next
    QLabel* title_;
    QLabel* text_;
    QPushButton* accept_;
    QPushButton* other_;
    QPushButton* dismiss_;
};

}  // namespace tiller
