// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A one-line label. If the text does not fit, it is elided and the tooltip shows the full text.

#include <QLabel>

namespace tiller {

class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    explicit ElidedLabel(const QString& text = {}, QWidget* parent = nullptr);

    QString fullText() const { return fullText_; }
    void setFullText(const QString& text);
    void setElideMode(Qt::TextElideMode mode);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void elide();

    QString fullText_;
    Qt::TextElideMode mode_ = Qt::ElideRight;
};

}  // namespace tiller
