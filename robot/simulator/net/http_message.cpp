// SPDX-License-Identifier: MIT
#include "robot/simulator/net/http_message.h"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "robot/core/ascii.h"

namespace tiller::simulator {

namespace {

std::string lowered(std::string_view text) {
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(), lower);
    return out;
}

/// In HTTP, only spaces and tabs are whitespace.
std::string_view withoutBlanks(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) {
        text.remove_prefix(1);
    }
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) {
        text.remove_suffix(1);
    }
    return text;
}

bool isToken(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
               std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
    });
}

std::optional<std::size_t> number(std::string_view text, int base) {
    std::size_t value = 0;
    const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value, base);
    const bool whole = parsed.ec == std::errc() && parsed.ptr == text.data() + text.size();
    return whole ? std::optional(value) : std::nullopt;
}

const char* reason(int status) {
    switch (status) {
        case 200:
            return "OK";
        case 400:
            return "Bad Request";
        case 403:
            return "Forbidden";
        case 404:
            return "Not Found";
        case 405:
            return "Method Not Allowed";
        case 409:
            return "Conflict";
        case 413:
            return "Content Too Large";
        case 422:
            return "Unprocessable Content";
        case 431:
            return "Request Header Fields Too Large";
        case 501:
            return "Not Implemented";
        case 504:
            return "Gateway Timeout";
        case 505:
            return "HTTP Version Not Supported";
        default:
            return "Internal Server Error";
    }
}

}  // namespace

std::string_view HttpRequest::header(std::string_view name) const {
    for (const auto& [key, value] : headers) {
        if (key == name) {
            return value;
        }
    }
    return {};
}

std::string HttpResponse::toBytes(bool keepAlive, bool withBody) const {
    std::string out = "HTTP/1.1 " + std::to_string(status) + ' ' + reason(status) + "\r\n";
    for (const auto& [name, value] : headers) {
        out += name + ": " + value + "\r\n";
    }
    out += "Content-Type: " + contentType + "\r\nContent-Length: " + std::to_string(body.size()) +
           "\r\nConnection: " + (keepAlive ? "keep-alive" : "close") + "\r\n\r\n";
    return withBody ? out + body : out;
}

void HttpParser::feed(std::string_view bytes) {
    if (fault_ != 0) {
        return;
    }
    if (at_ > 0 && at_ == buffer_.size()) {
        buffer_.clear();
        at_ = 0;
    } else if (at_ > kLargestHead) {
        buffer_.erase(0, at_);
        at_ = 0;
    }
    buffer_ += bytes;
}

std::optional<std::string_view> HttpParser::line() {
    const std::size_t end = buffer_.find('\n', at_);
    if (end == std::string::npos) {
        if (buffer_.size() - at_ > kLargestHead) {
            fail(431);
        }
        return std::nullopt;
    }
    std::string_view found(buffer_.data() + at_, end - at_);
    if (!found.empty() && found.back() == '\r') {
        found.remove_suffix(1);
    }
    headSize_ += end + 1 - at_;
    at_ = end + 1;
    if (headSize_ > kLargestHead) {
        fail(431);
        return std::nullopt;
    }
    return found;
}

std::optional<HttpRequest> HttpParser::next() {
    while (fault_ == 0) {
        if (!inBody_ && !readHead()) {
            return std::nullopt;
        }
        if (!readBody()) {
            return std::nullopt;
        }
        HttpRequest done = std::exchange(request_, {});
        inBody_ = false;
        headSize_ = 0;
        return done;
    }
    return std::nullopt;
}

bool HttpParser::readHead() {
    while (const auto text = line()) {
        if (!request_.method.empty() && text->empty()) {
            if (chunked_ && sawLength_) {
                fail(400);  // contradictory lengths are invalid
                return false;
            }
            inBody_ = true;
            continue_ = (chunked_ || length_ > 0) && lowered(request_.header("expect")) == "100-continue";
            return true;
        }
        if (!request_.method.empty()) {
            readHeader(*text);
        } else if (!text->empty()) {  // empty lines before a request are ignored
            const std::size_t first = text->find(' ');
            const std::size_t last = text->rfind(' ');
            const std::string_view version = last == std::string_view::npos ? "" : text->substr(last + 1);
            if (first == std::string_view::npos || first == last || !isToken(text->substr(0, first)) ||
                !version.starts_with("HTTP/")) {
                fail(400);
                return false;
            }
            if (version != "HTTP/1.1" && version != "HTTP/1.0") {
                fail(505);
                return false;
            }
            const std::string_view target = text->substr(first + 1, last - first - 1);
            const auto path = percentDecoded(target.substr(0, target.find('?')));
            if (!path || path->empty() || path->front() != '/') {
                fail(400);
                return false;
            }
            request_.method = text->substr(0, first);
            request_.path = *path;
            request_.keepAlive = version == "HTTP/1.1";
            chunked_ = sawLength_ = inTrailer_ = false;
            length_ = 0;
            chunk_.reset();
        }
        if (fault_ != 0) {
            return false;
        }
    }
    return false;
}

void HttpParser::readHeader(std::string_view text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos || !isToken(text.substr(0, colon))) {
        fail(400);
        return;
    }
    const std::string name = lowered(text.substr(0, colon));
    const std::string_view value = withoutBlanks(text.substr(colon + 1));
    if (name == "content-length") {
        const auto size = number(value, 10);
        if (!size || (sawLength_ && *size != length_)) {
            fail(400);
        } else if (*size > kLargestBody) {
            fail(413);
        } else {
            length_ = *size;
            sawLength_ = true;
        }
    } else if (name == "transfer-encoding") {
        lowered(value) == "chunked" ? void(chunked_ = true) : fail(501);
    } else if (name == "connection") {
        const std::string wish = lowered(value);
        request_.keepAlive = wish == "close" ? false : wish == "keep-alive" ? true : request_.keepAlive;
    }
    request_.headers.emplace_back(name, value);
}

bool HttpParser::readBody() {
    if (chunked_) {
        return readChunks();
    }
    if (buffer_.size() - at_ < length_) {
        return false;
    }
    request_.body = buffer_.substr(at_, length_);
    at_ += length_;
    return true;
}

bool HttpParser::readChunks() {
    while (fault_ == 0) {
        if (inTrailer_) {
            const auto text = line();
            if (!text) {
                return false;
            }
            if (text->empty()) {
                return true;
            }
            continue;
        }
        if (!chunk_) {
            const auto text = line();
            if (!text) {
                return false;
            }
            headSize_ = 0;
            const auto size = number(withoutBlanks(text->substr(0, text->find(';'))), 16);
            if (!size) {
                fail(400);
                return false;
            }
            if (*size > kLargestBody - request_.body.size()) {
                fail(413);
                return false;
            }
            inTrailer_ = *size == 0;
            chunk_ = inTrailer_ ? std::nullopt : size;
            continue;
        }
        if (buffer_.size() - at_ < *chunk_ + 2) {
            return false;
        }
        request_.body.append(buffer_, at_, *chunk_);
        at_ += *chunk_;
        if (buffer_.compare(at_, 2, "\r\n") != 0) {
            fail(400);
            return false;
        }
        at_ += 2;
        chunk_.reset();
        if (at_ > kLargestHead) {
            buffer_.erase(0, at_);
            at_ = 0;
        }
    }
    return false;
}

std::optional<std::string> percentDecoded(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            out += text[i];
            continue;
        }
        const auto code = i + 2 < text.size() ? number(text.substr(i + 1, 2), 16) : std::nullopt;
        if (!code) {
            return std::nullopt;
        }
        out += static_cast<char>(*code);
        i += 2;
    }
    return out;
}

namespace {

/// Returns the value of name="value" in a header. Empty if it is missing.
std::optional<std::string> parameter(std::string_view header, std::string_view name) {
    std::size_t at = header.find(';');
    while (at != std::string_view::npos) {
        std::size_t end = at + 1;
        for (bool quoted = false; end < header.size() && (quoted || header[end] != ';'); ++end) {
            quoted = header[end] == '"' ? !quoted : quoted;
        }
        std::string_view piece = withoutBlanks(header.substr(at + 1, end - at - 1));
        const std::size_t equals = piece.find('=');
        if (equals != std::string_view::npos && lowered(withoutBlanks(piece.substr(0, equals))) == name) {
            std::string_view value = withoutBlanks(piece.substr(equals + 1));
            if (value.size() >= 2 && value.front() == '"' && value.back() == '"') {
                value = value.substr(1, value.size() - 2);
            }
            return std::string(value);
        }
        at = end < header.size() ? end : std::string_view::npos;
    }
    return std::nullopt;
}

}  // namespace

std::optional<FormFile> fileOfForm(std::string_view contentType, std::string_view body,
                                   std::string_view field) {
    const auto boundary = parameter(contentType, "boundary");
    if (!lowered(contentType).starts_with("multipart/form-data") || !boundary || boundary->empty()) {
        return std::nullopt;
    }
    const std::string mark = "--" + *boundary;
    std::size_t at = body.find(mark);
    while (at != std::string_view::npos) {
        const std::size_t begin = at + mark.size();
        const std::size_t end = body.find("\r\n" + mark, begin);
        if (end == std::string_view::npos) {
            return std::nullopt;
        }
        std::string_view part = body.substr(begin, end - begin);
        const std::size_t blank = part.find("\r\n\r\n");
        if (part.starts_with("\r\n") && blank != std::string_view::npos) {
            std::string_view head = part.substr(2, blank - 2 + 2);
            while (!head.empty()) {
                const std::size_t eol = head.find("\r\n");
                const std::string_view text = head.substr(0, eol);
                head.remove_prefix(eol == std::string_view::npos ? head.size() : eol + 2);
                if (lowered(text).starts_with("content-disposition:") && parameter(text, "name") == field) {
                    return FormFile{parameter(text, "filename").value_or(""),
                                    std::string(part.substr(blank + 4))};
                }
            }
        }
        at = end + 2;
    }
    return std::nullopt;
}

}  // namespace tiller::simulator
