#pragma once

#include <kanexpr/base/bytes.hpp>
#include <kanexpr/mpi/messages.hpp>

#include <optional>
#include <string>

namespace kanexpr::mpi {

/// What a rank was sent.
struct letter {
  int from = 0;
  kind_of_message kind{};
  std::string content{};

  template <class Message>
  Message read() const {
    bytes_reader in(content);
    return Message::read(in);
  }
};

/// Carries messages between ranks, and waits for none of them: who they are for may be gone.
class mailbox {
public:
  mailbox() = default;
  mailbox(const mailbox&) = delete;
  mailbox& operator=(const mailbox&) = delete;
  virtual ~mailbox() = default;

  virtual int rank() const = 0;
  virtual int ranks() const = 0;
  virtual void send(int to, kind_of_message kind, std::string content) = 0;
  /// One that has come; none: there is no more.
  virtual std::optional<letter> receive() = 0;

  template <class Message>
  void send(int to, const Message& message) {
    bytes_writer out;
    message.write(out);
    send(to, Message::kind, out.bytes());
  }
};

} // namespace kanexpr::mpi
