using System.Buffers.Binary;

namespace Msisf.Adapters.Render;

/// <summary>
/// PNG's cyclic redundancy check (ISO/IEC 15948, annex D): reflected polynomial 0xEDB88320. Eight bytes at a time, by a table for each of
/// them (Kounavis and Berry, "A systematic approach to building high performance software-based CRC generators", 2005).
/// </summary>
internal static class PngCrc
{
    /// <summary>The state before the first byte.</summary>
    public const uint Start = 0xFFFFFFFF;

    private const int BytesAtOnce = 8;

    /// <summary>At 256 k + b: what byte b does to the state when k zero bytes follow it.</summary>
    private static readonly uint[] Table = MakeTable();

    /// <summary>The state after more bytes.</summary>
    public static uint Update(uint state, ReadOnlySpan<byte> bytes)
    {
        uint[] table = Table;
        for (; bytes.Length >= BytesAtOnce; bytes = bytes[BytesAtOnce..])
        {
            uint first = state ^ BinaryPrimitives.ReadUInt32LittleEndian(bytes);
            uint second = BinaryPrimitives.ReadUInt32LittleEndian(bytes[4..]);
            state = table[0x700 + (byte)first] ^ table[0x600 + (byte)(first >> 8)]
                ^ table[0x500 + (byte)(first >> 16)] ^ table[0x400 + (int)(first >> 24)]
                ^ table[0x300 + (byte)second] ^ table[0x200 + (byte)(second >> 8)]
                ^ table[0x100 + (byte)(second >> 16)] ^ table[(int)(second >> 24)];
        }

        foreach (byte b in bytes)
        {
            state = table[(byte)state ^ b] ^ (state >> 8);
        }

        return state;
    }

    /// <summary>The check value that a file stores for a state.</summary>
    public static uint Finish(uint state) => ~state;

    private static uint[] MakeTable()
    {
        uint[] table = new uint[BytesAtOnce * 256];
        for (int i = 0; i < table.Length; i++)
        {
            table[i] = i < 256 ? EntryOf((uint)i) : table[(byte)table[i - 256]] ^ (table[i - 256] >> 8);
        }

        return table;
    }

    private static uint EntryOf(uint entry)
    {
        for (int bit = 0; bit < 8; bit++)
        {
            entry = (entry & 1) == 0 ? entry >> 1 : 0xEDB88320 ^ (entry >> 1);
        }

        return entry;
    }
}
