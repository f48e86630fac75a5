// SPDX-License-Identifier: MIT
#pragma once

// URScript text under construction: indented lines, and labels from which clients determine the running node.

#include <QString>
#include <utility>
#include <vector>

namespace tiller::simulator::pendant {

/// A part of the program tree that has no statement in the script, and its position in the script.
struct NodeMark {
    enum class Kind {
        FolderBegin,
        FolderEnd,
        Comment,
        DisabledBegin,
        DisabledEnd,
        Omitted  ///< a node without effect that is not translated
    };
    Kind kind = Kind::Comment;
    int line = 0;    ///< the mark is before this line, counted from 0
    int number = 0;  ///< line in the program tree; 0: none
    QString text;    ///< name of the folder, text of the comment, reason
};

class ScriptText {
public:
    explicit ScriptText(int depth = 0) : depth_(depth) {}

    void line(const QString& text) {
        append(QString(2 * depth_, ' ') + text + '\n');
        ++statements_;
    }
    /// number  line in the program tree; 0: the node has no line
    void label(int number, QString text) {
        if (number > 0) {
            text.replace('"', '\'').replace('\n', ' ').replace('\r', ' ');
            append(QString(2 * depth_, ' ') + QStringLiteral("$ %1 \"%2\"\n").arg(number).arg(text));
        }
    }
    void mark(NodeMark::Kind kind, int number, const QString& text = {}) {
        marks_.push_back({kind, lines_, number, text});
    }
    /// Resets the number of statements to an earlier value, so that the statements since then do not count.
    void setStatements(int statements) { statements_ = statements; }
    void indent() { ++depth_; }
    void outdent() { --depth_; }
    int depth() const { return depth_; }
    int statements() const { return statements_; }  ///< number of lines that are not labels
    const QString& text() const { return text_; }
    const std::vector<NodeMark>& marks() const { return marks_; }
    void append(const ScriptText& other) {
        for (NodeMark mark : other.marks_) {
            mark.line += lines_;
            marks_.push_back(std::move(mark));
        }
        append(other.text_);
        statements_ += other.statements_;
    }

private:
    void append(const QString& text) {
        text_ += text;
        lines_ += static_cast<int>(text.count('\n'));
    }

    QString text_;
    std::vector<NodeMark> marks_;
    int lines_ = 0;
    int depth_;
    int statements_ = 0;
};

}  // namespace tiller::simulator::pendant
