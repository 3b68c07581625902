using System.Runtime.Intrinsics;
using Msisf.Core.Detector.Noise;
using Xunit;

namespace Msisf.Core.Tests.Detector.Noise;

public sealed class Philox4x32Tests
{
    /// <summary>Random123 1.14, tests/kat_vectors, lines "philox4x32 10".</summary>
    [Theory]
    [InlineData(0u, 0u, 0u, 0u, 0u, 0u, 0x6627e8d5u, 0xe169c58du, 0xbc57ac4cu, 0x9b00dbd8u)]
    [InlineData(
        0xffffffffu, 0xffffffffu, 0xffffffffu, 0xffffffffu, 0xffffffffu, 0xffffffffu, 0x408f276du, 0x41c83b0eu, 0xa20bc7c6u, 0x6d5451fdu)]
    [InlineData(
        0x243f6a88u, 0x85a308d3u, 0x13198a2eu, 0x03707344u, 0xa4093822u, 0x299f31d0u, 0xd16cfe09u, 0x94fdccebu, 0x5001e420u, 0x24126ea1u)]
    public void Block_PublishedCounters_GivePublishedWords(
        uint c0, uint c1, uint c2, uint c3, uint k0, uint k1, uint w0, uint w1, uint w2, uint w3)
    {
        ulong key = k0 | ((ulong)k1 << 32);
        Assert.Equal((w0, w1, w2, w3), Philox4x32.Block((c0, c1, c2, c3), key));

        Vector512<ulong> first = Vector512.Create((ulong)c0, c0 ^ 1u, c0 ^ 2u, c0 ^ 3u, c0 ^ 4u, c0 ^ 5u, c0 ^ 6u, c0 ^ 7u);
        (Vector512<ulong> second, Vector512<ulong> third, Vector512<ulong> fourth) =
            (Vector512.Create((ulong)c1), Vector512.Create((ulong)c2), Vector512.Create((ulong)c3));
        Philox4x32.Blocks(ref first, ref second, ref third, ref fourth, key);
        Assert.Equal((w0, w1, w2, w3), ((uint)first[0], (uint)second[0], (uint)third[0], (uint)fourth[0]));
        Assert.Equal(
            Philox4x32.Block((c0 ^ 7u, c1, c2, c3), key), ((uint)first[7], (uint)second[7], (uint)third[7], (uint)fourth[7]));
    }
}
