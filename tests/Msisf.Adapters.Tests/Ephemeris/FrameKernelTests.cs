using Msisf.Adapters.Ephemeris;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Adapters.Tests.Ephemeris;

public class FrameKernelTests
{
    private const string Pck = "FRAME_PA = 7\nFRAME_7_CLASS = 2\nFRAME_7_CLASS_ID = 31006\n";
    private const string Me = "FRAME_ME = 8\nFRAME_8_CLASS = 4\nFRAME_8_CLASS_ID = 8\nTKFRAME_8_RELATIVE = 'PA'\n";

    [Fact]
    public void ReadBodyFixedFrame_PckFrame_IsNotTurned() =>
        Assert.Equal(new BodyFixedFrame(31006, RotationMatrix.Identity), FrameKernel.ReadBodyFixedFrame(SamplePool.Of(Pck), "PA"));

    [Fact]
    public void ReadBodyFixedFrame_Matrix_IsReadColumnByColumnAndInverted()
    {
        // The matrix takes the frame's x to the relative frame's y; so the frame's rows are the relative frame's y, -x, z.
        BodyFixedFrame frame = FrameKernel.ReadBodyFixedFrame(
            SamplePool.Of(Pck + Me + "TKFRAME_8_SPEC = 'MATRIX'\nTKFRAME_8_MATRIX = ( 0 1 0 -1 0 0 0 0 1 )"), "ME");

        Assert.Equal(new RotationMatrix(Vector3D.UnitY, -Vector3D.UnitX, Vector3D.UnitZ), frame.FrameFromOrientation);
    }

    [Theory]
    [InlineData("67.92 78.56 0.30", "ARCSECONDS")]
    [InlineData("1.132 1.3093333333333333 0.005", "ARCMINUTES")]
    [InlineData("0.018866666666666667 0.021822222222222222 0.00008333333333333333", "DEGREES")]
    [InlineData("0.0003292854522095968 0.00038086962787965147 1.4544410433286078e-06", "RADIANS")]
    public void ReadBodyFixedFrame_AnglesOfDe421_AreCSpices(string angles, string units)
    {
        BodyFixedFrame frame = FrameKernel.ReadBodyFixedFrame(
            SamplePool.Of(
                Pck + Me + $"TKFRAME_8_SPEC = 'ANGLES'\nTKFRAME_8_ANGLES = ( {angles} )\nTKFRAME_8_AXES = ( 3 2 1 )\nTKFRAME_8_UNITS = "
                    + $"'{units}'"), "ME");

        // CSPICE N0067, moon_080317.tf: pxform_c("MOON_PA_DE421", "MOON_ME_DE421", 0, rows); tests/reference/ephemeris.py.
        Assert.Equal(
            0.0,
            (frame.FrameFromOrientation.Row0 - new Vector3D(0.999999873254714, -0.00032928542237557117, 0.0003808696186713873)).Length,
            1e-15);
        Assert.Equal(
            0.0,
            (frame.FrameFromOrientation.Row1 - new Vector3D(0.000329286000210947, 0.9999999457843058, -1.4544409378362703e-06)).Length,
            1e-15);
        Assert.Equal(
            0.0,
            (frame.FrameFromOrientation.Row2 - new Vector3D(-0.000380869119096078, 1.5798557868269077e-06, 0.9999999274681064)).Length,
            1e-15);
    }

    /// <summary>CSPICE N0067, pxform_c: the first column is kept, the third is made first.</summary>
    [Fact]
    public void ReadBodyFixedFrame_MatrixOfRoundedNumbers_IsMadeARotationAsInCSpice()
    {
        BodyFixedFrame frame = FrameKernel.ReadBodyFixedFrame(
            SamplePool.Of(Pck + Me + "TKFRAME_8_SPEC = 'matrix'\nTKFRAME_8_MATRIX = ( 0.8 0.6001 0 -0.6 0.8 0 0 0 1 )"), "me");

        // 0.8 and 0.6001 over their length; printed by CSPICE as 0.799952, 0.600064.
        Vector3D x = new Vector3D(0.8, 0.6001, 0.0).Normalized();
        Assert.Equal(0.0, (frame.FrameFromOrientation.Row0 - x).Length, 1e-15);
        Assert.Equal(0.0, (frame.FrameFromOrientation.Row1 - new Vector3D(-x.Y, x.X, 0.0)).Length, 1e-15);
    }

    /// <summary>CSPICE takes the data of a TK frame from the variables of its class ID, by number or by the name that this has.</summary>
    [Theory]
    [InlineData("TKFRAME_9")]
    [InlineData("TKFRAME_OTHER")]
    public void ReadBodyFixedFrame_ClassIdOfAnotherFrame_HasTheDataOfThat(string prefix)
    {
        string data = Pck + "FRAME_ME = 8\nFRAME_8_CLASS = 4\nFRAME_8_CLASS_ID = 9\nFRAME_OTHER = 9\nFRAME_9_NAME = 'OTHER'\n"
            + "TKFRAME_8_RELATIVE = 'PA'\nTKFRAME_8_SPEC = 'QUATERNION'\nTKFRAME_8_Q = ( 1 0 0 0 )\n"
            + $"{prefix}_RELATIVE = 'pa'\n{prefix}_SPEC = 'QUATERNION'\n{prefix}_Q = ( 2 0 0 2 )";

        // A quarter turn about z: the frame's x is the other's y.
        Assert.Equal(
            0.0,
            (FrameKernel.ReadBodyFixedFrame(SamplePool.Of(data), "ME").FrameFromOrientation.Row0 - Vector3D.UnitY).Length,
            1e-15);
    }

    [Theory]
    [InlineData("HOURANGLE", 6.0)]
    [InlineData("minuteangle", 360.0)]
    [InlineData("SECONDANGLE", 21600.0)]
    [InlineData("degrees", 90.0)]
    public void ReadBodyFixedFrame_UnitOfAngles_IsRead(string unit, double quarterTurn)
    {
        BodyFixedFrame frame = FrameKernel.ReadBodyFixedFrame(
            SamplePool.Of(
                Pck + Me + $"TKFRAME_8_SPEC = 'ANGLES'\nTKFRAME_8_AXES = ( 3 2 1 )\nTKFRAME_8_UNITS = '{unit}'\nTKFRAME_8_ANGLES = "
                    + FormattableString.Invariant($"( {quarterTurn} 0 0 )")), "ME");

        Assert.Equal(0.0, (frame.FrameFromOrientation.Row0 - -Vector3D.UnitY).Length, 1e-15); // CSPICE: as for DEGREES
    }

    [Fact]
    public void ReadBodyFixedFrame_ItemsByName_AreFoundToo() =>
        Assert.Equal(
            9,
            FrameKernel.ReadBodyFixedFrame(SamplePool.Of("FRAME_PA = 7\nFRAME_PA_CLASS = 2\nFRAME_PA_CLASS_ID = 9"), "PA").OrientationBody);

    [Theory]
    [InlineData(Me, "No frame kernel defines the frame PA (ME -> PA)")]
    [InlineData(
        Me
            + "FRAME_PA = 7\nFRAME_7_CLASS = 4\nFRAME_7_CLASS_ID = 7\nTKFRAME_7_RELATIVE = 'ME'\nTKFRAME_7_SPEC = 'MATRIX'\n"
            + "TKFRAME_7_MATRIX = ( 1 0 0 0 1 0 0 "
            + "0 1 )",
        "defined by itself: ME -> PA -> ME")]
    [InlineData(Me + "FRAME_PA = 7\nFRAME_7_CLASS = 5\nFRAME_7_CLASS_ID = 7", "frame PA is of class 5")]
    [InlineData(Me + "FRAME_PA = 7", "FRAME_7_CLASS")]
    [InlineData(Me + "FRAME_PA = 7.5", "FRAME_PA is 7.5, a whole number expected")]
    public void ReadBodyFixedFrame_WrongChain_SaysWhere(string data, string expected) =>
        AssertFails(data + "\nTKFRAME_8_SPEC = 'MATRIX'\nTKFRAME_8_MATRIX = ( 1 0 0 0 1 0 0 0 1 )", expected);

    [Theory]
    [InlineData("TKFRAME_8_SPEC = 'MATRIX'\nTKFRAME_8_MATRIX = ( 1 0 0 0 1 0 0 0 )", "has 8 numbers, 9 expected")]
    [InlineData("TKFRAME_8_SPEC = 'MATRIX'\nTKFRAME_8_MATRIX = ( 1 0 0 0 1 0 0 0 1.01 )", "is not a rotation")]
    [InlineData("TKFRAME_8_SPEC = 'MATRIX'\nTKFRAME_8_MATRIX = ( 1 0 0 0 1 0 0 0 -1 )", "is not a rotation")]
    [InlineData("TKFRAME_8_SPEC = 'AXIS'", "given as AXIS")]
    [InlineData(
        "TKFRAME_8_SPEC = 'ANGLES'\nTKFRAME_8_ANGLES = ( 1 2 3 )\nTKFRAME_8_AXES = ( 3 2 4 )\nTKFRAME_8_UNITS = 'DEGREES'",
        "three of the axes 1, 2 and 3")]
    [InlineData("TKFRAME_8_SPEC = 'ANGLES'\nTKFRAME_8_ANGLES = ( 1 2 3 )\nTKFRAME_8_AXES = ( 3 2 1 )\nTKFRAME_8_UNITS = 'GON'", "is GON")]
    [InlineData("TKFRAME_8_SPEC = 3", "must be one text")]
    public void ReadBodyFixedFrame_WrongSpecification_SaysWhere(string specification, string expected) =>
        AssertFails(Pck + Me + specification, expected);

    private static void AssertFails(string data, string expected)
    {
        BadInputException failure = Assert.Throws<BadInputException>(() => FrameKernel.ReadBodyFixedFrame(SamplePool.Of(data), "ME"));

        Assert.Contains(expected, failure.Message, StringComparison.Ordinal);
    }
}
