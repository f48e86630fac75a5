// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A part of the window: a rounded surface with a title bar and one content widget below it. The title bar
// contains the title, a subtitle, small controls, and a hint at the right end.

#include <QFrame>
#include <QVector>

class QHBoxLayout;
class QLabel;
class QVBoxLayout;

namespace tiller {

class ElidedLabel;

class Panel : public QFrame {
    Q_OBJECT

public:
    explicit Panel(const QString& title, QWidget* parent = nullptr);

    QString title() const;
    void setTitle(const QString& title);
    /// Grey text after the title.
    void setSubtitle(const QString& text);
    /// Grey text at the right end of the title bar. It is elided if the panel is narrow.
    void setHint(const QString& text);
    /// Adds a small control at the right end of the title bar.
    void addHeaderWidget(QWidget* widget);
    /// Like addHeaderWidget(), but hides the control if the panel is too narrow. The control must also be
    /// available elsewhere. The control added first is hidden first.
    void addFoldingHeaderWidget(QWidget* widget);
    /// Replaces the title, the subtitle and the hint by a widget, e.g. a tab bar. The height of the title bar
    /// does not change.
    void setHeaderWidget(QWidget* widget);
    /// Takes ownership of the widget and deletes the previous content.
    void setContent(QWidget* content);
    QWidget* content() const { return content_; }

    static constexpr int kHeaderHeight = 34;

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void foldHeader();

    QWidget* header_;
    QHBoxLayout* headerLayout_;
    QVBoxLayout* layout_;
    QLabel* title_;
    QLabel* subtitle_;
    ElidedLabel* hint_;
    QWidget* content_ = nullptr;
    QVector<QWidget*> folding_;
};

}  // namespace tiller
