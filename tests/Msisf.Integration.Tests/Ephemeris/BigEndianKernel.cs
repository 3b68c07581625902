using System.Buffers.Binary;
using System.Text;

namespace Msisf.Integration.Tests.Ephemeris;

/// <summary>Turns a little-endian binary kernel into a big-endian one, by NAIF's DAF Required Reading.</summary>
internal static class BigEndianKernel
{
    private const int Record = 1024;

    public static byte[] Of(byte[] kernel)
    {
        byte[] turned = [.. kernel];
        int integers = BinaryPrimitives.ReadInt32LittleEndian(kernel.AsSpan(12));
        int words = 2 + ((integers + 1) / 2);
        int first = BinaryPrimitives.ReadInt32LittleEndian(kernel.AsSpan(76));
        foreach (int at in (int[])[8, 12, 76, 80, 84])
        {
            turned.AsSpan(at, 4).Reverse();
        }

        Encoding.ASCII.GetBytes("BIG-IEEE").CopyTo(turned, 88);
        HashSet<int> special = [0];
        for (int record = first; record != 0;)
        {
            int at = (record - 1) * Record;
            int next = (int)BinaryPrimitives.ReadDoubleLittleEndian(kernel.AsSpan(at));
            int count = (int)BinaryPrimitives.ReadDoubleLittleEndian(kernel.AsSpan(at + 16));
            Reverse(turned, at, 3, 8);
            for (int i = 0; i < count; i++)
            {
                Reverse(turned, at + 24 + (8 * words * i), 2, 8);
                Reverse(turned, at + 24 + (8 * words * i) + 16, integers, 4);
            }

            special.UnionWith([record - 1, record]); // the record of names behind it stays
            record = next;
        }

        int data = special.Max() + 1;
        for (int record = data; record * Record < kernel.Length; record++)
        {
            Reverse(turned, record * Record, Math.Min(Record, kernel.Length - (record * Record)) / 8, 8);
        }

        return turned;
    }

    private static void Reverse(byte[] bytes, int at, int count, int size)
    {
        for (int i = 0; i < count; i++)
        {
            bytes.AsSpan(at + (i * size), size).Reverse();
        }
    }
}
