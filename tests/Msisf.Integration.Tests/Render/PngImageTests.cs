using Msisf.Adapters.Render;
using Msisf.Core.Render.Photometry;
using Xunit;

namespace Msisf.Integration.Tests.Render;

/// <summary>A PNG whose rows come a few at a time has the bytes of one whose rows come at once.</summary>
public sealed class PngImageTests
{
    [Theory]
    [InlineData(701, 300)]
    [InlineData(50_000, 9)]
    [InlineData(1, 40)]
    public void Add_RowsInParts_GivesTheSameBytes(int width, int height)
    {
        byte[] levels = new byte[width * height];
        new Random(5).NextBytes(levels);
        Array.Fill(levels, (byte)7, levels.Length / 3, levels.Length / 3);
        ushort[] numbers = [.. levels.Select(level => (ushort)(level * 16))];
        foreach (int part in (int[])[1, 7, height])
        {
            using MemoryStream whole = new();
            PngWriter.Write(whole, levels, width, GreyTransfer.Srgb);
            using MemoryStream parts = new();
            using (PngImage image = new(parts, width, height, 8, GreyTransfer.Srgb))
            {
                for (int row = 0; row < height; row += part)
                {
                    image.Add(levels.AsSpan(row * width, Math.Min(part, height - row) * width));
                }
            }

            Assert.Equal(whole.ToArray(), parts.ToArray());
            using MemoryStream wholeNumbers = new();
            PngWriter.WriteNumbers(wholeNumbers, numbers, width, 12);
            using MemoryStream partsOfNumbers = new();
            using (PngImage image = PngImage.OfNumbers(partsOfNumbers, width, height, 12))
            {
                for (int row = 0; row < height; row += part)
                {
                    image.Add(numbers.AsSpan(row * width, Math.Min(part, height - row) * width));
                }
            }

            Assert.Equal(wholeNumbers.ToArray(), partsOfNumbers.ToArray());
        }
    }
}
