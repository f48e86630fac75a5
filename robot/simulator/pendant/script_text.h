// SPDX-License-Identifier: MIT
#pragma once

// URScript text under construction: indented lines, and labels from which clients determine the running node.

#include <QString>
#include <utility>

namespace tiller::simulator::pendant {

class ScriptText {
public:
    explicit ScriptText(int depth = 0) : depth_(depth) {}

    void line(const QString& text) {
        text_ += QString(2 * depth_, ' ') + text + '\n';
        ++statements_;
    }
    /// number  line in the program tree; 0: the node has no line
    void label(int number, QString text) {
        if (number > 0) {
            text.replace('"', '\'').replace('\n', ' ').replace('\r', ' ');
            text_ += QString(2 * depth_, ' ') + QStringLiteral("$ %1 \"%2\"\n").arg(number).arg(text);
        }
    }
    void indent() { ++depth_; }
    void outdent() { --depth_; }
    int depth() const { return depth_; }
    int statements() const { return statements_; }  ///< number of lines that are not labels
    const QString& text() const { return text_; }
    void append(const ScriptText& other) {
        text_ += other.text_;
        statements_ += other.statements_;
    }

private:
    QString text_;
    int depth_;
    int statements_ = 0;
};

}  // namespace tiller::simulator::pendant
