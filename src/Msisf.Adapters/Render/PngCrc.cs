namespace Msisf.Adapters.Render;

/// <summary>PNG's cyclic redundancy check (ISO/IEC 15948, annex D): reflected polynomial 0xEDB88320.</summary>
internal static class PngCrc
{
    /// <summary>The state before the first byte.</summary>
    public const uint Start = 0xFFFFFFFF;

    private static readonly uint[] Table = [.. Enumerable.Range(0, 256).Select(TableEntry)];

    /// <summary>The state after more bytes.</summary>
    public static uint Update(uint state, ReadOnlySpan<byte> bytes)
    {
        foreach (byte b in bytes)
        {
            state = Table[(byte)state ^ b] ^ (state >> 8);
        }

        return state;
    }

    /// <summary>The check value that a file stores for a state.</summary>
    public static uint Finish(uint state) => ~state;

    private static uint TableEntry(int index)
    {
        uint entry = (uint)index;
        for (int bit = 0; bit < 8; bit++)
        {
            entry = (entry & 1) == 0 ? entry >> 1 : 0xEDB88320 ^ (entry >> 1);
        }

        return entry;
    }
}
