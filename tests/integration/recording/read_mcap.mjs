// SPDX-License-Identifier: MIT
// Reads an MCAP file with the official MCAP libraries and prints its content as JSON.
// node read_mcap.mjs NODE_MODULES FILE
import { createRequire } from "node:module";
import { open } from "node:fs/promises";
const load = createRequire(process.argv[2] + "/");
const { McapIndexedReader, McapStreamReader } = load("@mcap/core");
const { loadDecompressHandlers } = load("@mcap/support");
const { parse } = load("@foxglove/rosmsg");
const { MessageReader } = load("@foxglove/rosmsg2-serialization");

const file = await open(process.argv[3], "r");
const bytes = new Uint8Array(await file.readFile());
const decompressHandlers = await loadDecompressHandlers();
const readable = {
  size: async () => BigInt(bytes.length),
  read: async (offset, length) => bytes.subarray(Number(offset), Number(offset + length)),
};
const reader = await McapIndexedReader.Initialize({ readable, decompressHandlers });
const decoders = new Map();
for (const channel of reader.channelsById.values()) {
  const schema = reader.schemasById.get(channel.schemaId);
  const definitions = parse(new TextDecoder().decode(schema.data), { ros2: true });
  decoders.set(channel.id, new MessageReader(definitions));
}
const topics = {};
for await (const message of reader.readMessages({ validateCrcs: true })) {
  const channel = reader.channelsById.get(message.channelId);
  const decoded = decoders.get(message.channelId).readMessage(message.data);
  const seen = (topics[channel.topic] ??= {
    count: 0,
    schema: reader.schemasById.get(channel.schemaId).name,
    encoding: channel.messageEncoding,
  });
  seen.first ??= decoded;
  seen.last = decoded;
  seen.lastPublish = message.publishTime.toString();
  ++seen.count;
}
// Read the file again from beginning to end as a stream.
const stream = new McapStreamReader({ decompressHandlers, validateCrcs: true });
stream.append(bytes);
let streamed = 0;
for (let record; (record = stream.nextRecord()); ) {
  streamed += record.type === "Message" ? 1 : 0;
}
const metadata = {};
for await (const record of reader.readMetadata()) {
  metadata[record.name] = Object.fromEntries(record.metadata);
}
const attachments = {};
for await (const attachment of reader.readAttachments({ validateCrcs: true })) {
  attachments[attachment.name] = new TextDecoder().decode(attachment.data);
}
const plain = (key, value) =>
  typeof value === "bigint" ? value.toString() : ArrayBuffer.isView(value) ? Array.from(value) : value;
console.log(
  JSON.stringify(
    { profile: reader.header.profile, topics, streamed, metadata, attachments,
      messages: reader.statistics.messageCount, chunks: reader.chunkIndexes.length, done: stream.done() },
    plain));
