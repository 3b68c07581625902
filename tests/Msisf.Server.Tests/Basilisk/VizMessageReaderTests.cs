using System.Buffers.Binary;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Server.Basilisk;
using Xunit;

namespace Msisf.Server.Tests.Basilisk;

/// <summary>Messages whose bytes are put together here, by the wire format of protobuf.</summary>
public sealed class VizMessageReaderTests
{
    [Fact]
    public void Read_TimeBodyAndCamera_HasTheirFields()
    {
        byte[] body = [.. Text(1, "moon"), .. Packed(2, [1.0, 2.0, 3.0]), .. Single(4, 0.5), .. Single(4, 0.25)];
        byte[] camera = [0x08, 0x05, .. Text(2, "sat"), 0x22, 0x02, 0x40, 0x30, .. Packed(7, [4.0])]; // id 5; 64 x 48 px, packed
        byte[] message = [.. Nested(1, Single(2, 2.5e9)), .. Nested(2, body), .. Nested(4, camera), 0x7D, 1, 2, 3, 4]; // an unknown field

        VizMessage read = VizMessageReader.Read(message);

        Assert.Equal(2.5, read.SimulationSeconds); // from nanoseconds
        Assert.Null(read.Epoch);
        VizBody moon = Assert.Single(read.Bodies);
        Assert.Equal(("moon", new Vector3D(1.0, 2.0, 3.0)), (moon.Name, moon.Position));
        Assert.Equal([0.5, 0.25], moon.BodyFromInertial);
        VizCamera found = Assert.Single(read.Cameras);
        Assert.Equal((5, "sat", 64, 48, 0), (found.Id, found.Parent, found.Width, found.Height, found.RenderMode));
        Assert.Equal(new Vector3D(4.0, 0.0, 0.0), found.Position); // what is missing is 0
        Assert.Empty(read.Spacecraft);
    }

    [Theory]
    [InlineData(new byte[] { 0x12, 0x05, 0x00 })] // a body that is longer than the message
    [InlineData(new byte[] { 0x00 })] // no tag
    [InlineData(new byte[] { 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF })]
    public void Read_OtherBytes_AreNoMessage(byte[] bytes) => Assert.StartsWith(
        "the message is not a VizMessage of Basilisk: ", Assert.Throws<BadInputException>(() => VizMessageReader.Read(bytes)).Message,
        StringComparison.Ordinal);

    private static byte[] Nested(int field, byte[] bytes) => [(byte)((field << 3) | 2), (byte)bytes.Length, .. bytes];

    private static byte[] Text(int field, string text) => Nested(field, System.Text.Encoding.UTF8.GetBytes(text));

    private static byte[] Packed(int field, double[] numbers) => Nested(field, [.. numbers.SelectMany(Eight)]);

    private static byte[] Single(int field, double number) => [(byte)((field << 3) | 1), .. Eight(number)];

    private static byte[] Eight(double number)
    {
        byte[] bytes = new byte[sizeof(double)];
        BinaryPrimitives.WriteDoubleLittleEndian(bytes, number);
        return bytes;
    }
}
